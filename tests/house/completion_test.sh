#!/bin/bash
# The shells complete what the program offers, and nothing that it does not know.
# completion_test.sh COMPLETIONS_FOLDER [PROGRAM]
. "$(dirname -- "$0")/lib.sh"
completions=$1
program=${2:-}
# shellcheck source=/dev/null
. "$completions/fusee.bash"
set +e
cd "$work" || exit 1
mkdir 'some folder'
touch 'my arm.toml' notes.txt rows.csv

# after WORDS... : what bash offers for the last word
after() {
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    _fusee 2>/dev/null
    printf '%s\n' "${COMPREPLY[@]}" | sort | paste -sd'|'
}
expect_same 'commands' '--help|--version|blind|calibrate|case-template|check|completion|coupons|design|diagnose|fix|identify|keys|make|paper|predict|rules|simulate' "$(after fusee '')"
expect_same 'a command begun' 'keys' "$(after fusee k)"
expect_same 'profiles and folders' 'my arm.toml|some folder' "$(after fusee make '')"
expect_same 'a second profile' 'my arm.toml' "$(after fusee make a.toml my)"
expect_same 'options' '--force|--help|--jobs|--out|--via' "$(after fusee make a.toml -)"
expect_same 'folders' 'some folder' "$(after fusee make --out '')"
expect_same 'kernels' 'cgal|openscad' "$(after fusee make --via '')"
expect_same 'rows' 'rows.csv|some folder' "$(after fusee identify '')"
expect_same 'options of identify' '--force|--help|--out' "$(after fusee identify -)"
expect_same 'options of coupons' '--force|--help|--out' "$(after fusee coupons a.toml -)"
expect_same 'options of calibrate' '--force|--help|--json|--profile|--write-profile' "$(after fusee calibrate rows.csv -)"
expect_same 'sheets' 'rows.csv|some folder' "$(after fusee calibrate '')"
expect_same 'options of design' '--force|--generations|--help|--jobs|--method|--out|--population|--resume|--seed' "$(after fusee design a.toml -)"
expect_same 'options of simulate' '--at|--force|--help|--jobs|--levels|--out|--push-torque' "$(after fusee simulate a.toml -)"
expect_same 'options of diagnose' '--force|--help|--jobs|--out|--profile|--write-profile' "$(after fusee diagnose case -)"
expect_same 'cases' 'some folder' "$(after fusee diagnose '')"
expect_same 'options of predict' '--effects|--force|--help|--inputs|--out' "$(after fusee predict case -)"
expect_same 'folder of inputs' 'some folder' "$(after fusee predict case --inputs '')"
expect_same 'options of case-template' '--force|--help|--out' "$(after fusee case-template a.toml -)"
expect_same 'profiles of case-template' 'my arm.toml|some folder' "$(after fusee case-template '')"
expect_same 'steps of blind' '--help|make|score' "$(after fusee blind '')"
expect_same 'options of blind make' '--cases|--force|--help|--jobs|--out|--plant|--seed' "$(after fusee blind make -)"
expect_same 'options of blind score' '--again|--force|--help|--jobs|--limit|--model|--out|--seal' "$(after fusee blind score bench -)"
expect_same 'benchmarks' 'some folder' "$(after fusee blind score '')"
expect_same 'makers' 'model|plant' "$(after fusee blind make --plant '')"
expect_same 'methods' 'algorithm_1|co_design|pareto' "$(after fusee design --method '')"
expect_same 'options of paper' '--force|--help|--jobs|--out|--profiles' "$(after fusee paper -)"
expect_same 'folder of profiles' 'some folder' "$(after fusee paper --profiles '')"
expect_same 'options of check' '--force|--help|--jobs|--json|--limits|--out|--process|--profile' "$(after fusee check a.toml -)"
expect_same 'what is checked' 'my arm.toml|some folder' "$(after fusee check '')"
expect_same 'processes' 'all|edm|fdm|laser|mill|mill4|sla|sls' "$(after fusee check --process '')"
expect_same 'options of rules' '--help|--json' "$(after fusee rules -)"
expect_same 'shells' 'bash|fish|zsh' "$(after fusee completion '')"

for word in make simulate diagnose predict case-template effects inputs profile write-profile levels push-torque design method population generations seed resume force identify coupons calibrate blind seal score cases plant model limit again paper check process limits profiles keys rules completion out via jobs cgal openscad help version; do
    for shell in bash zsh fish; do
        grep -qw -- "$word" "$completions/fusee.$shell" || fail "fusee.$shell does not know '$word'"
    done
done
for shell in zsh fish; do
    if command -v $shell >/dev/null; then $shell -n "$completions/fusee.$shell" || fail "fusee.$shell"; fi
done

[ -n "$program" ] || exit 0
"$program" --help >"$work/help"
for word in make simulate design identify coupons calibrate diagnose predict case-template blind paper check keys rules completion --version; do expect_in 'fusee --help' "$word" "$work/help"; done
"$program" make --help >"$work/help"
for word in --out --via --jobs --force cgal openscad; do expect_in 'fusee make --help' "$word" "$work/help"; done
"$program" simulate --help >"$work/help"
for word in --out --levels --push-torque --jobs; do expect_in 'fusee simulate --help' "$word" "$work/help"; done
"$program" design --help >"$work/help"
for word in --method --out --population --generations --seed --jobs --resume; do expect_in 'fusee design --help' "$word" "$work/help"; done
"$program" diagnose --help >"$work/help"
for word in --out --profile --write-profile --jobs; do expect_in 'fusee diagnose --help' "$word" "$work/help"; done
"$program" predict --help >"$work/help"
for word in --effects --inputs --out; do expect_in 'fusee predict --help' "$word" "$work/help"; done
"$program" case-template --help >"$work/help"
expect_in 'fusee case-template --help' --out "$work/help"
"$program" blind make --help >"$work/help"
for word in --seed --cases --plant --jobs --out; do expect_in 'fusee blind make --help' "$word" "$work/help"; done
"$program" blind score --help >"$work/help"
for word in --seal --model --limit --again --jobs --out; do expect_in 'fusee blind score --help' "$word" "$work/help"; done
"$program" paper --help >"$work/help"
for word in --out --profiles --jobs; do expect_in 'fusee paper --help' "$word" "$work/help"; done
"$program" check --help >"$work/help"
for word in --process --profile --out --json --jobs mill4 all; do expect_in 'fusee check --help' "$word" "$work/help"; done
for shell in bash zsh fish; do
    "$program" completion $shell >"$work/script" || fail "fusee completion $shell"
    cmp "$work/script" "$completions/fusee.$shell" || fail "fusee completion $shell prints another script"
done
