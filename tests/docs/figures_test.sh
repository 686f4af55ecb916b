#!/bin/bash
# docs/figures compares and makes figures: a wrong figure and a changed sentence are told with their page, and it writes the true figure back.
# figures_test.sh PROGRAM SOURCE
. "$(dirname -- "$0")/../house/lib.sh"
program=$1 source=$2
mkdir "$work/clone"
cp -r "$source/docs" "$source/README.md" "$work/clone"
ln -s "$source/profiles" "$work/clone/profiles"
figures() { "$source/docs/figures" --root "$work/clone" --program "$program" --source budget --source simulation --only "$@" >"$work/log" 2>&1; }
page=$work/clone/docs/simulation.md

figures --check || { cat "$work/log" >&2; fail 'simulation.md and the program differ: ./docs/figures makes its figures again'; }
sed -i 's/^\(| `pnrvsa` .*\)75\.5 deg/\174.5 deg/' "$page"
cmp -s "$page" "$source/docs/simulation.md" && fail 'the test changed no figure'
figures --check && fail 'a wrong figure passed'
grep -q 'simulation.md:.*says' "$work/log" || { cat "$work/log" >&2; fail 'the page is not named'; }
figures || { cat "$work/log" >&2; fail 'the figures could not be made'; }
cmp "$page" "$source/docs/simulation.md" || fail 'the true figure was not written back'
sed -i 's/^| `pnrvsa` | stiction-compensating/| `pnrvsa` | stiction-compensated/' "$page"
figures --check && fail 'a changed sentence passed'
grep -q 'stands there 0 times' "$work/log" || { cat "$work/log" >&2; fail 'the lost sentence is not named'; }
figures --check --source nothing && fail 'an unknown source passed'
grep -q 'nothing: unknown (allowed: budget' "$work/log" || { cat "$work/log" >&2; fail 'the sources are not listed'; }
exit 0
