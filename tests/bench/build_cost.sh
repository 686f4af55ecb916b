#!/bin/bash
# Builds fusee and its tests from nothing, without a compiler cache, and prints the cost as Markdown: units, processor seconds by module and
# the ten slowest units.
# build_cost.sh [update]: "update" writes it into docs/guides/build.md, between its marks.
set -eu
source=$(readlink -f -- "$(dirname -- "$0")/../..")
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
export FUSEE_BUILD_COST=$work/cost LC_ALL=C
launcher=$source/tests/bench/timed_command.sh

cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" \
    -DCMAKE_CXX_LINKER_LAUNCHER="$launcher" >"$work/log"
build() { # TARGET: appends "target wall-seconds units"
    local begin=$SECONDS
    cmake --build "$work/build" --target "$1" >>"$work/log"
    echo "$1 $((SECONDS - begin))" >>"$work/wall"
    sed 's/ CMakeFiles/ app/' "$work/cost" | awk -v target="$1" '{ print target, $0 }' >>"$work/all"
    : >"$work/cost"
}
: >"$work/all"
build fusee_app
build all

# target user system output -> target seconds module file
awk '{
    module = $4; file = $4
    if (sub(/^src\//, "", module)) { sub(/\/.*/, "", module) } else if (sub(/^tests\//, "", module)) { sub(/\/.*/, "", module); module = "tests of " module } else module = "links of programs"
    sub(/CMakeFiles\/[^\/]*\.dir\//, "", file); sub(/\.o$/, "", file)
    print $1 "\t" $2 + $3 "\t" module "\t" file
}' "$work/all" >"$work/table"

report() {
    echo "Made by \`tests/bench/build_cost.sh update\` on $(nproc) processors ($(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)), $(c++ -dumpfullversion | sed 's/^/g++ /'), no compiler cache."
    echo
    echo '| target | commands | processor time [s] | time [s] |'
    echo '|---|---|---|---|'
    while read -r target wall; do
        awk -F '\t' -v target="$target" -v wall="$wall" '$1 == target { n++; s += $2 }
            END { printf "| %s | %d | %.0f | %d |\n", target == "fusee_app" ? "`./fusee ARGS`" : "then `./fusee test`", n, s, wall }' "$work/table"
    done <"$work/wall"
    echo
    echo '| module | units | processor time [s] |'
    echo '|---|---|---|'
    awk -F '\t' '{ n[$3]++; s[$3] += $2 } END { for (m in n) printf "| %s | %d | %.1f |\n", m, n[m], s[m] }' "$work/table" | sort -t '|' -k 4,4 -rn |
        awk -F '|' '$4 >= 10 { print; next } { modules++; units += $3; seconds += $4 }
            END { if (modules) printf "| %d others | %d | %.1f |\n", modules, units, seconds }'
    echo
    echo '| slowest unit | processor time [s] |'
    echo '|---|---|'
    sort -t "$(printf '\t')" -k 2,2 -rn "$work/table" | head -n 10 | awk -F '\t' '{ printf "| %s | %.1f |\n", $4, $2 }'
}
report >"$work/report"
cat "$work/report"
[ "${1:-}" = update ] || exit 0
page=$source/docs/guides/build.md
awk -v report="$work/report" '
    /<!-- build cost: end -->/ { inside = 0 }
    !inside { print }
    /<!-- build cost: begin -->/ { inside = 1; while ((getline line < report) > 0) print line }' "$page" >"$work/page"
cp "$work/page" "$page"
