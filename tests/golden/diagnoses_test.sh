#!/bin/bash
# The diagnoses of the open gap cases are the ones of tests/golden/diagnoses.sha256, byte for byte but for the version that they carry.
# FUSEE_GAP_CASES names the folder of the cases; FUSEE_GOLDEN_CASES which of them are run (default: case00 case04; "all" takes minutes).
# diagnoses_test.sh PROGRAM SOURCE [update]: "update" writes the hashes anew, for a change that is meant.
. "$(dirname -- "$0")/../house/lib.sh"
program=$1 source=$2
golden=$source/tests/golden/diagnoses.sha256
[ -d "${FUSEE_GAP_CASES:-}" ] || skip 'FUSEE_GAP_CASES names no folder of open cases'
cases=${FUSEE_GOLDEN_CASES:-case00 case04}
[ "$cases" != all ] || cases=$(sed 's/.* //' "$golden")
if [ "${3:-}" = update ]; then cases=$(cd "$FUSEE_GAP_CASES" && find . -mindepth 2 -maxdepth 2 -name case.toml | cut -d / -f 2 | LC_ALL=C sort); fi

for name in $cases; do
    "$program" diagnose "$FUSEE_GAP_CASES/$name" --out "$work/$name" >"$work/log" 2>&1 || {
        cat "$work/log" >&2
        fail "$name cannot be diagnosed"
    }
    printf '%s  %s\n' "$(sed 's/"fusee": "[0-9.]*"/"fusee": "VERSION"/' "$work/$name/diagnosis.json" | sha256sum | cut -d ' ' -f 1)" "$name"
done >"$work/found"
if [ "${3:-}" = update ]; then
    cp "$work/found" "$golden"
    exit 0
fi
for name in $cases; do grep " $name\$" "$golden"; done >"$work/wanted"
diff "$work/wanted" "$work/found" >"$work/diff" || {
    sed -n 's/^> [0-9a-f]* */changed: /p' "$work/diff" >&2
    fail 'these diagnoses have changed. If that is meant: tests/golden/diagnoses_test.sh PROGRAM SOURCE update'
}
printf '%s diagnoses as before\n' "$(wc -l <"$work/found")"
