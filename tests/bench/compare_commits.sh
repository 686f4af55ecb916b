#!/bin/bash
# Compares time and peak memory of this commit with its parent, or with another one, or of two programs.
# compare_commits.sh [COMMIT [RUNS]]: builds both, runs each command RUNS times in turn (7 unless said otherwise) and prints the medians and their ratios.
# compare_commits.sh --programs BEFORE AFTER RUNS ARGUMENTS...: two programs that are built, with each ARGUMENTS (one word: one command).
# Exit code 1: a command takes more than 1.10 times the time, or 1.20 times the memory. 2: it does not run.
set -eu
source=$(readlink -f -- "$(dirname -- "$0")/../..")
work=$(mktemp -d)
trap 'git -C "$source" worktree remove --force "$work/base" 2>/dev/null || true; rm -rf -- "$work"' EXIT
build() { # SOURCE BUILD
    cmake -S "$1" -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Release -DFUSEE_BUILD_TESTS=OFF >"$work/log"
    cmake --build "$2" --target fusee_app >>"$work/log" || {
        tail -n 30 "$work/log" >&2
        exit 2
    }
}
compare_commits() { # COMMIT: both programs, and the commands
    git -C "$source" worktree add --quiet --detach "$work/base" "$1"
    build "$work/base" "$work/build_before"
    build "$source" "$work/build_after"
    before=$work/build_before/bin/fusee after=$work/build_after/bin/fusee
    sed 's/^formats = .*/formats = ["stl"]/' "$source/profiles/pnrvsa.toml" >"$work/stl.toml"
    cat >"$work/study.toml" <<'END'
[study]
base = "stl.toml"
outputs = "figures"
[vary]
k_se.hub.bore_mm = {from = 5.0, to = 6.0, steps = 10}
END
    "$after" make "$work/stl.toml" --out "$work/out" >/dev/null
    commands=("make $work/stl.toml" "make $source/profiles/pnrvsa.toml" "check $source/profiles/pnrvsa.toml"
        "check $work/out/pnrvsa/k_pe.stl --process fdm" "simulate $source/profiles/pnrvsa.toml" "batch $work/study.toml")
}
if [ "${1:-}" = --programs ]; then
    before=$2 after=$3 runs=$4
    commands=("${@:5}")
else
    runs=${2:-7}
    compare_commits "${1:-HEAD^}"
fi
c++ -std=c++20 -O1 -o "$work/run_cost" "$source/tests/bench/run_cost.cpp"
median() { sort -n | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

echo '| command | time before [s] | now [s] | ratio | memory before [MB] | now [MB] | ratio |'
echo '|---|---|---|---|---|---|---|'
slower=0
for number in "${!commands[@]}"; do
    command=${commands[$number]}
    for run in $(seq "$runs"); do
        for side in before after; do # in turn, so that a busy moment meets both
            folder=$work/$side.$number.$run
            case $command in make* | simulate* | batch*) target=(--out "$folder") ;; *) target=() ;; esac
            # shellcheck disable=SC2086  # a command is several words
            "$work/run_cost" "${!side}" $command "${target[@]}" >>"$work/$side.$number" || [ $? = 1 ] || {
                echo "failed: $side $command" >&2
                exit 2
            }
            rm -rf "$folder"
        done
    done
    values=$(for column in 1 2; do for side in before after; do cut -d ' ' -f $column "$work/$side.$number" | median; done; done | tr '\n' ' ')
    echo "$values" | awk -v command="$(echo "$command" | sed "s|$work/||g;s|$source/||g")" \
        '{ printf "| `%s` | %.3f | %.3f | %.2f | %.0f | %.0f | %.2f |\n", command, $1, $2, $2 / $1, $3, $4, $4 / $3; exit $2 > 1.10 * $1 || $4 > 1.20 * $3 }' || slower=1
done
exit "$slower"
