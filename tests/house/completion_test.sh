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
expect_same 'commands' '--help|--version|completion|design|identify|keys|make|paper|rules|simulate' "$(after fusee '')"
expect_same 'a command begun' 'keys' "$(after fusee k)"
expect_same 'profiles and folders' 'my arm.toml|some folder' "$(after fusee make '')"
expect_same 'a second profile' 'my arm.toml' "$(after fusee make a.toml my)"
expect_same 'options' '--help|--jobs|--out|--via' "$(after fusee make a.toml -)"
expect_same 'folders' 'some folder' "$(after fusee make --out '')"
expect_same 'kernels' 'cgal|openscad' "$(after fusee make --via '')"
expect_same 'rows' 'rows.csv|some folder' "$(after fusee identify '')"
expect_same 'options of identify' '--help|--out' "$(after fusee identify -)"
expect_same 'options of design' '--generations|--help|--jobs|--method|--out|--population|--resume|--seed' "$(after fusee design a.toml -)"
expect_same 'options of simulate' '--at|--help|--jobs|--levels|--out|--push-torque' "$(after fusee simulate a.toml -)"
expect_same 'methods' 'algorithm_1|co_design|pareto' "$(after fusee design --method '')"
expect_same 'options of paper' '--help|--jobs|--out|--profiles' "$(after fusee paper -)"
expect_same 'folder of profiles' 'some folder' "$(after fusee paper --profiles '')"
expect_same 'shells' 'bash|fish|zsh' "$(after fusee completion '')"

for word in make simulate levels push-torque design method population generations seed resume identify paper profiles keys rules completion out via jobs cgal openscad help version; do
    for shell in bash zsh fish; do
        grep -qw -- "$word" "$completions/fusee.$shell" || fail "fusee.$shell does not know '$word'"
    done
done
for shell in zsh fish; do
    if command -v $shell >/dev/null; then $shell -n "$completions/fusee.$shell" || fail "fusee.$shell"; fi
done

[ -n "$program" ] || exit 0
"$program" --help >"$work/help"
for word in make simulate design identify paper keys rules completion --version; do expect_in 'fusee --help' "$word" "$work/help"; done
"$program" make --help >"$work/help"
for word in --out --via --jobs cgal openscad; do expect_in 'fusee make --help' "$word" "$work/help"; done
"$program" simulate --help >"$work/help"
for word in --out --levels --push-torque --jobs; do expect_in 'fusee simulate --help' "$word" "$work/help"; done
"$program" design --help >"$work/help"
for word in --method --out --population --generations --seed --jobs --resume; do expect_in 'fusee design --help' "$word" "$work/help"; done
"$program" paper --help >"$work/help"
for word in --out --profiles --jobs; do expect_in 'fusee paper --help' "$word" "$work/help"; done
for shell in bash zsh fish; do
    "$program" completion $shell >"$work/script" || fail "fusee completion $shell"
    cmp "$work/script" "$completions/fusee.$shell" || fail "fusee completion $shell prints another script"
done
