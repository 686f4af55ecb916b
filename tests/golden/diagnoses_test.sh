#!/bin/bash
# The diagnoses of the open gap cases have the figures of tests/golden/diagnoses.jsonl; diagnosis_digest.cpp says what is compared, and how.
# FUSEE_GAP_CASES names the folder of the cases; FUSEE_GOLDEN_CASES which of them are run (default: case00 case04; "all" takes minutes).
# diagnoses_test.sh PROGRAM DIGEST SOURCE [update]: "update" writes the figures anew, for a change that is meant.
. "$(dirname -- "$0")/../house/lib.sh"
program=$1 digest=$2 source=$3
golden=$source/tests/golden/diagnoses.jsonl
[ -d "${FUSEE_GAP_CASES:-}" ] || skip 'FUSEE_GAP_CASES names no folder of open cases'
cases=${FUSEE_GOLDEN_CASES:-case00 case04}
if [ "$cases" = all ] || [ "${4:-}" = update ]; then
    cases=$(cd "$FUSEE_GAP_CASES" && find . -mindepth 2 -maxdepth 2 -name case.toml | cut -d / -f 2 | LC_ALL=C sort)
fi

for name in $cases; do
    "$program" diagnose "$FUSEE_GAP_CASES/$name" --out "$work/$name" >"$work/log" 2>&1 || {
        cat "$work/log" >&2
        fail "$name cannot be diagnosed"
    }
    "$digest" print "$name" "$work/$name/diagnosis.json"
done >"$work/found.jsonl"
if [ "${4:-}" = update ]; then
    cp "$work/found.jsonl" "$golden"
    exit 0
fi
"$digest" compare "$golden" "$work/found.jsonl" ||
    fail 'these diagnoses have changed. If that is meant: tests/golden/diagnoses_test.sh PROGRAM DIGEST SOURCE update'
