#!/bin/bash
# The programs of designs and of diagnoses print the help of the whole one, hold the commands that ./fusee builds them for, and hand over the rest:
# the same line, once, with its words, output and exit code.
# programs_test.sh FOLDER_OF_PROGRAMS SOURCE
. "$(dirname -- "$0")/lib.sh"
programs=$(readlink -f -- "$1") source=$(readlink -f -- "$2")
cd "$work"
printf '#!/bin/sh\nprintf "handed over, %%s" "$FUSEE_DOOR"\nfor word; do printf "|%%s" "$word"; done\necho\nexit 7\n' >launcher
chmod +x launcher
"$programs/fusee" --help >help
commands=$(sed -n '/^Make a part:/,/^Example:/s/^  \([a-z-]*\) .*/\1/p' help)
[ "$(wc -w <<<"$commands")" -gt 20 ] || fail "the help lists: $commands"

held() { # PROGRAM: the commands whose own help it prints
    for command in $commands; do
        FUSEE_LAUNCHER=$work/launcher "$programs/$1" "$command" --help >out 2>&1 || true
        grep -q '^handed over, whole|' out || printf '%s ' "$command"
    done
}
for program in fusee-make fusee-diagnose; do
    "$programs/$program" --help | cmp - help || fail "$program: another help"
done
expect_same 'the program of diagnoses' 'identify diagnose predict ' "$(held fusee-diagnose)"
expect_in 'the launcher names them' '    diagnose | identify | predict) program=diagnose ;;' "$source/fusee"
expect_same 'the program of designs' 'make check springs budget coupons calibrate keys ' "$(held fusee-make)"

hands_over() { # WORDS OF THE LINE
    code=0
    FUSEE_LAUNCHER=$work/launcher "$programs/$1" "${@:2}" >out 2>err || code=$?
    expect_same "$*: code" 7 "$code"
    expect_same "$*: words" "handed over, whole$(printf '|%s' "${@:2}")" "$(cat out err)"
}
hands_over fusee-make paper --out 'a b'
hands_over fusee-make --json explain --no-such-option x
hands_over fusee-diagnose diagnose "$source/profiles/gap/paper_table_1" -o d --profile p.toml
[ ! -e d ] || fail 'something was written before the line was handed over'
printf 'solid s\nendsolid s\n' >part.stl
hands_over fusee-make check part.stl --process fdm

# Without a launcher: the whole program beside it.
expect_same 'beside it' "$("$programs/fusee" explain cable.bend_ratio)" "$("$programs/fusee-make" explain cable.bend_ratio)"
code=0
"$programs/fusee-diagnose" explain no.such.name 2>err || code=$?
expect_same 'its exit code' 2 "$code"
cp "$programs/fusee-make" .
code=0
./fusee-make paper >out 2>err || code=$?
expect_same 'neither' 2 "$code"
expect_in 'neither' 'does not start' err
