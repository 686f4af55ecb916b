#!/bin/bash
# Compares time and peak memory of this commit with its parent, or with another one.
# compare_commits.sh [COMMIT [RUNS]]: builds both, runs each command RUNS times in turn (7 unless said otherwise) and prints the medians and their ratios.
# Exit code 1: a command takes more than 1.10 times the time, or 1.20 times the memory.
set -eu
source=$(readlink -f -- "$(dirname -- "$0")/../..")
base=${1:-HEAD^} runs=${2:-7}
work=$(mktemp -d)
trap 'git -C "$source" worktree remove --force "$work/base" 2>/dev/null || true; rm -rf -- "$work"' EXIT
git -C "$source" worktree add --quiet --detach "$work/base" "$base"
build() { # SOURCE BUILD
    cmake -S "$1" -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Release -DFUSEE_BUILD_TESTS=OFF >"$work/log"
    cmake --build "$2" --target fusee_app >>"$work/log" || {
        tail -n 30 "$work/log" >&2
        exit 2
    }
}
build "$work/base" "$work/before"
build "$source" "$work/after"
c++ -std=c++20 -O1 -o "$work/run_cost" "$source/tests/bench/run_cost.cpp"

sed 's/^formats = .*/formats = ["stl"]/' "$source/profiles/pnrvsa.toml" >"$work/stl.toml"
cat >"$work/study.toml" <<'END'
[study]
base = "stl.toml"
outputs = "figures"
[vary]
k_se.hub.bore_mm = {from = 5.0, to = 6.0, steps = 10}
END
"$work/after/bin/fusee" make "$work/stl.toml" --out "$work/out" >/dev/null
commands=("make $work/stl.toml" "make $source/profiles/pnrvsa.toml" "check $source/profiles/pnrvsa.toml" "check $work/out/pnrvsa/k_pe.stl --process fdm"
    "simulate $source/profiles/pnrvsa.toml" "batch $work/study.toml")
median() { sort -n | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

echo '| command | time before [s] | now [s] | ratio | memory before [MB] | now [MB] | ratio |'
echo '|---|---|---|---|---|---|---|'
slower=0
for number in "${!commands[@]}"; do
    command=${commands[$number]}
    for run in $(seq "$runs"); do
        for side in before after; do # in turn, so that a busy moment meets both
            folder=$work/$side.$number.$run
            case $command in check*) target=() ;; *) target=(--out "$folder") ;; esac
            # shellcheck disable=SC2086  # a command is several words
            "$work/run_cost" "$work/$side/bin/fusee" $command "${target[@]}" >>"$work/$side.$number" || [ $? = 1 ] || echo "failed: $side $command" >&2
            rm -rf "$folder"
        done
    done
    values=$(for column in 1 2; do for side in before after; do cut -d ' ' -f $column "$work/$side.$number" | median; done; done | tr '\n' ' ')
    echo "$values" | awk -v command="$(echo "$command" | sed "s|$work/||g;s|$source/||g")" \
        '{ printf "| `%s` | %.3f | %.3f | %.2f | %.0f | %.0f | %.2f |\n", command, $1, $2, $2 / $1, $3, $4, $4 / $3; exit $2 > 1.10 * $1 || $4 > 1.20 * $3 }' || slower=1
done
exit "$slower"
