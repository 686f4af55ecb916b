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
touch 'my arm.toml' notes.txt

# after WORDS... : what bash offers for the last word
after() {
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    _fusee 2>/dev/null
    printf '%s\n' "${COMPREPLY[@]}" | sort | paste -sd'|'
}
expect_same 'commands' '--help|--version|completion|keys|make|rules' "$(after fusee '')"
expect_same 'a command begun' 'keys' "$(after fusee k)"
expect_same 'profiles and folders' 'my arm.toml|some folder' "$(after fusee make '')"
expect_same 'a second profile' 'my arm.toml' "$(after fusee make a.toml my)"
expect_same 'options' '--help|--jobs|--out|--via' "$(after fusee make a.toml -)"
expect_same 'folders' 'some folder' "$(after fusee make --out '')"
expect_same 'kernels' 'cgal|openscad' "$(after fusee make --via '')"
expect_same 'shells' 'bash|fish|zsh' "$(after fusee completion '')"

for word in make keys rules completion out via jobs cgal openscad help version; do
    for shell in bash zsh fish; do
        grep -qw -- "$word" "$completions/fusee.$shell" || fail "fusee.$shell does not know '$word'"
    done
done
for shell in zsh fish; do
    if command -v $shell >/dev/null; then $shell -n "$completions/fusee.$shell" || fail "fusee.$shell"; fi
done

[ -n "$program" ] || exit 0
"$program" --help >"$work/help"
for word in make keys rules completion --version; do expect_in 'fusee --help' "$word" "$work/help"; done
"$program" make --help >"$work/help"
for word in --out --via --jobs cgal openscad; do expect_in 'fusee make --help' "$word" "$work/help"; done
for shell in bash zsh fish; do
    "$program" completion $shell >"$work/script" || fail "fusee completion $shell"
    cmp "$work/script" "$completions/fusee.$shell" || fail "fusee completion $shell prints another script"
done
