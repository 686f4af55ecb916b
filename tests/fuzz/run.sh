#!/bin/bash
# Runs the libFuzzer programs one after the other and prints a row for each: docs/robustness.md.
# run.sh BUILD FOLDER RUNS SECONDS [READER ...]: at most RUNS inputs and SECONDS each; FOLDER keeps corpus and findings.
set -eu
build=$1 folder=$2 runs=$3 seconds=$4
shift 4
readers=${*:-$("$build/tests/fuzz/fuzz_inputs")}
bin=$build/tests/fuzz

export UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1
for reader in $readers; do
    corpus=$folder/$reader/corpus found=$folder/$reader/found
    mkdir -p "$corpus" "$found" "$folder/$reader/seeds"
    "$bin/fuzz_inputs" "$reader" dictionary >"$folder/$reader/words.dict"
    "$bin/fuzz_inputs" "$reader" | while read -r seed; do cp "$seed" "$folder/$reader/seeds/"; done
    # A crash inside a library is counted and the run goes on: fusee reads such files in a process of its own.
    fork=''
    case $reader in stl | obj | 3mf | step) fork='-fork=1 -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1' ;; esac
    status=0
    # shellcheck disable=SC2086
    "$bin/fuzz_$reader" "$corpus" "$folder/$reader/seeds" -dict="$folder/$reader/words.dict" -runs="$runs" -max_total_time="$seconds" \
        -max_len=20000 -timeout=20 -rss_limit_mb=3000 -artifact_prefix="$found/" -print_final_stats=1 $fork \
        >"$folder/$reader/log" 2>&1 || status=$?
    done_runs=$(sed -n 's/^stat::number_of_executed_units: *//p; s/^#\([0-9]*\): cov.*/\1/p' "$folder/$reader/log" | tail -1)
    covered=$(grep -o 'cov: [0-9]*' "$folder/$reader/log" | tail -1 | cut -d' ' -f2)
    printf '| `%s` | %s | %s | %s | %s |\n' "$reader" "${done_runs:-0}" "${covered:-0}" "$(find "$found" -type f | wc -l)" "$status"
done
