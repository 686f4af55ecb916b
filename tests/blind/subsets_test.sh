#!/bin/sh
# One blind case, diagnosed from each experiment alone: an answer each time, and a rig with an effect is never called `none`.
# The table of docs/benchmark.md has 40 cases and the pairs.     subsets_test.sh PROGRAM
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
. "$here/../house/lib.sh"
program=$(readlink -f -- "$1")
cd "$work"
"$program" blind make --seed 7 --cases 1 --out bench -q >log 2>&1 || fail "blind make: $(cat log)"
python3 "$here/subsets.py" "$program" bench out 1 0
[ "$(wc -l <out/rows.jsonl)" -eq 6 ] || fail 'not six answers'
