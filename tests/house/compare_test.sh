#!/bin/bash
# compare_test.sh SOURCE PROGRAM: the table of before and after (tests/bench/cost.py --before) on programs whose costs are known, and on fusee. It
# asserts no time of fusee; whole comparisons of two commits are made by hand.
set -eu
guard=$1/tests/bench/cost.py program=$2
fail() {
    echo "$1" >&2
    exit 1
}
printf '#!/bin/sh\nexit 0\n' >light
printf '#!/bin/bash\nfor ((i = 0; i < 100000; ++i)); do :; done\n' >slow
printf '#!/bin/bash\nx=$(head -c 30000000 /dev/zero | tr "\\0" a)\n' >large
printf '#!/bin/sh\nexit 3\n' >broken
chmod +x light slow large broken
code=0
guarded() { # BEFORE AFTER COMMAND...
    code=0
    "$guard" "$2" --before "$1" --runs 1 "${@:3}" >table 2>errors || code=$?
}
guarded "$PWD/light" "$PWD/slow" x
[ $code = 1 ] || fail "a slower program passed: $(cat table)"
guarded "$PWD/light" "$PWD/large" x
[ $code = 1 ] && awk -F '|' '/`x`/ { exit !($8 > 1.2) }' table || fail "a larger program passed: $(cat table)"
guarded "$PWD/slow" "$PWD/light" x
[ $code = 0 ] || fail "a faster program failed: $(cat table)"
guarded "$PWD/light" "$PWD/broken" x
[ $code = 2 ] && grep -q 'failed: after x' errors || fail "a program that does not run passed: $(cat table errors)"
guarded nowhere "$PWD/light" x
[ $code = 2 ] && grep -q 'nowhere: neither a program nor a commit' errors || fail "another program that is not there passed: $(cat table errors)"
[ -n "$program" ] || exit 0
guarded "$program" "$program" rules keys
[ $code -le 1 ] && [ "$(grep -c '^| `' table)" = 2 ] || fail "fusee beside itself: $(cat table errors)"
