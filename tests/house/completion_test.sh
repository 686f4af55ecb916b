#!/bin/bash
# The program prints the completion scripts, which work, and a manual page without faults.
# completion_test.sh SOURCE_FOLDER PROGRAM
. "$(dirname -- "$0")/lib.sh"
here=$(cd -- "$(dirname -- "$0")" && pwd)
completions=$1/completions
program=$2
[ -n "$program" ] || skip 'the program is not built'

for shell in bash zsh fish; do
    "$program" completion $shell | cmp - "$completions/fusee.$shell" || fail "fusee completion $shell"
done
if command -v shellcheck >/dev/null; then shellcheck "$completions/fusee.bash" || fail 'shellcheck'; fi
"$program" man >"$work/fusee.1" || fail 'fusee man'
if command -v groff >/dev/null; then
    expect_same 'warnings of groff' '' "$(groff -man -Tutf8 -ww -z "$work/fusee.1" 2>&1)"
fi

# shellcheck source=/dev/null
. "$completions/fusee.bash"
set +e
cd "$work" || exit 1
rm fusee.1
mkdir 'some folder'
touch 'my arm.toml' notes.txt rows.csv part.stl

# after WORDS... : what bash offers for the last word
after() {
    COMP_WORDS=("$program" "$@")
    COMP_CWORD=$#
    _fusee 2>/dev/null
    printf '%s\n' "${COMPREPLY[@]}" | sort | paste -sd'|'
}
# listed COMMAND...: the subcommands, or else the options, that its help lists
listed() {
    "$program" "$@" --help | sed -n "$pattern" | sort | paste -sd'|'
}
# Bash offers what the help of each command lists.
same_as_help() {
    local pattern='s/^ *\(-[a-zA-Z],\)\?\(--[a-z-]*\).*/\2/p' commands
    expect_same "options of $*" "$(listed "$@")" "$(after "$@" -)"
    pattern='/^\(Make a part\|Test a joint\|Look up\|Subcommands\):/,/^$/ s/^  \([a-z][a-z-]*\) .*/\1/p'
    commands=$(listed "$@")
    for command in ${commands//|/ }; do same_as_help "$@" "$command"; done
    tested=$((tested + 1))
}
tested=0
same_as_help
[ "$tested" -ge 23 ] || fail "only $tested commands were compared with their help"

expect_same 'a command begun' 'keys' "$(after k)"
expect_same 'profiles and folders' 'my arm.toml|some folder' "$(after make '')"
expect_same 'a second profile' 'my arm.toml' "$(after make a.toml my)"
expect_same 'folders' 'some folder' "$(after make --out '')"
expect_same 'folders of -o' 'some folder' "$(after make -o s)"
expect_same 'folders of --out=' 'some folder' "$(after make --out = s)"
expect_same 'folders of -os' '-osome folder' "$(after make -os)"
expect_same 'an option that is given' '' "$(after make --json --jso)"
expect_same 'a set of values' 'cgal|openscad' "$(after make --via '')"
expect_same 'a number' '' "$(after make --jobs '')"
expect_same 'steps of blind' 'make|score' "$(after blind '' | sed 's/--[a-z]*|//g')"
expect_same 'a step of the same name as a command' 'model|mujoco|plant|siconos' "$(after blind make --plant '')"
expect_same 'meshes' 'my arm.toml|part.stl|some folder' "$(after check '')"
expect_same 'keys' "$("$program" keys --names | grep '^k_pe\.hub' | sort | paste -sd'|')" "$(after fix --keep k_pe.hub)"

if command -v fish >/dev/null; then
    # fish offers "WORD<tab>MEANING"
    in_fish() {
        fish --no-config -c "source '$completions/fusee.fish'; set -p PATH '$(dirname -- "$program")'; complete -C 'fusee $1'" | cut -f1 | sort | paste -sd'|'
    }
    expect_same 'fish: a command begun' 'keys' "$(in_fish k)"
    expect_same 'fish: profiles and folders' 'my arm.toml|some folder/' "$(in_fish 'make ')"
    expect_same 'fish: folders' 'some folder/' "$(in_fish 'make --out ')"
    expect_same 'fish: a set of values' 'cgal|openscad' "$(in_fish 'make --via ')"
    expect_same 'fish: a step of the same name as a command' 'model|mujoco|plant|siconos' "$(in_fish 'blind make --plant ')"
    expect_same 'fish: options' "$(after paper --)" "$(in_fish 'paper --')"
    expect_same 'fish: keys' "$(after fix --keep k_pe.hub)" "$(in_fish 'fix --keep k_pe.hub')"
else
    echo 'fish is not installed: its script was not run'
fi
if command -v zsh >/dev/null; then
    zsh -f "$here/completion_test.zsh" "$completions" "$program" || fail 'zsh'
else
    echo 'zsh is not installed: its script was not run'
fi
