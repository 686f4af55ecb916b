#!/bin/bash
# Every kind of page in Debian's Chromium: no error, no request, no finding of axe, no sideways scroll, charts and links that work, a summary
# without scripts. Pictures of the pages are in BUILD/browser. Without browser, node, npm or the packages of npm it is skipped with the reason.
# browser_test.sh PROGRAM SOURCE BUILD
. "$(dirname -- "$0")/../house/lib.sh"
program=$(readlink -f -- "$1") source=$(readlink -f -- "$2") modules=$(readlink -f -- "$3")/browser
for tool in chromium node npm; do command -v $tool >/dev/null || skip "$tool is not installed: no page was opened"; done

mkdir -p "$modules"
if ! cmp -s "$source/tests/browser/package-lock.json" "$modules/package-lock.json" || [ ! -e "$modules/done" ]; then
    rm -f "$modules/done"
    cp "$source/tests/browser/package.json" "$source/tests/browser/package-lock.json" "$source/tests/browser/.npmrc" "$modules"
    (cd "$modules" && timeout 120 npm ci >npm.log 2>&1) || skip 'npm ci failed, without its registry: no page was opened'
    touch "$modules/done"
fi

# The pages, each made as a user makes it.
cd "$work"
cat >small.toml <<END
[study]
base = "$source/profiles/pnrvsa.toml"
outputs = "figures"
[vary]
cable.diameter_mm = [0.7, 0.8, 3.0]
END
"$program" make "$source/profiles/pnrvsa.toml" -o made >make.log 2>&1 || fail "make: $(cat make.log)"
"$program" make "$source/profiles/single/gravity_balance.toml" -o single >single.log 2>&1 || fail "make of one spring: $(cat single.log)"
"$program" diagnose "$source/profiles/gap/paper_table_1" -o diagnosed >diagnose.log 2>&1 || fail "diagnose: $(cat diagnose.log)"
"$program" case-template "$source/profiles/pnrvsa.toml" --out monday >template.log 2>&1 || fail "case-template: $(cat template.log)"
for rows in breakaway spring_pull cocontraction; do cp "$source/profiles/examples/bench_monday/$rows.csv" monday; done
sed -i -E '/^(dead_band|joint_stiffness|log) *=/d' monday/case.toml  # these three name both effects in an eighth of the time of all six
"$program" diagnose monday -o marked --profile "$source/profiles/pnrvsa.toml" >marked.log 2>&1 || fail "diagnose --profile: $(cat marked.log)"
"$program" identify "$source/profiles/examples/break_away.csv" -o identified >identify.log 2>&1 || fail "identify: $(cat identify.log)"
"$program" design "$source/profiles/pnrvsa.toml" --population 8 --generations 2 -o found >design.log 2>&1 || fail "design: $(cat design.log)"
"$program" batch small.toml -o study >batch.log 2>&1 || fail "batch: $(cat batch.log)"

node "$source/tests/browser/small_pages.mjs" "$work"

pages=
for page in report=made/pnrvsa/report.html one_spring=single/gravity_balance/report.html assembly=made/pnrvsa/assembly.html simulation=made/pnrvsa/simulation.html diagnosis=diagnosed/diagnosis.html \
    diagnosis_joint=marked/diagnosis.html \
    "identification=$(ls identified/*.html identified/*/*.html 2>/dev/null | head -n 1)" "study=$(find study -name index.html | head -n 1)" \
    "search=$(find found -name design.html | head -n 1)" pareto=pareto.html score=score.html paper=paper.html; do
    [ -s "${page#*=}" ] || fail "${page%%=*}: there is no page ${page#*=}"
    pages="$pages ${page%%=*}=$work/${page#*=}"
done
cp "$source"/tests/browser/{pages,checks,tasks}.mjs "$modules"  # beside its node_modules
# shellcheck disable=SC2086  # one word a page
CHROMIUM=$(command -v chromium) node "$modules/pages.mjs" "$modules" $pages
