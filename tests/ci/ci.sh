#!/bin/bash
# What ./fusee test leaves out: every source compiled alone, clang-tidy on the sources changed since a commit, and the tests of the core modules
# with both sanitizers. All of it ends within the limit, or it fails.
# ci.sh [COMMIT [MINUTES]]: COMMIT: HEAD~1; MINUTES: 60
set -eu
source=$(readlink -f -- "$(dirname -- "$0")/../..")
commit=${1:-HEAD~1} limit=$((60 * ${2:-60}))
cd "$source"

step() { # WHAT COMMAND...
    local begin=$SECONDS
    timeout "$((limit - SECONDS > 1 ? limit - SECONDS : 1))" "${@:2}" || {
        echo "ci: failed, or over the limit: $1" >&2
        exit 1
    }
    echo "ci: $1: $((SECONDS - begin)) s"
}

# The changed sources; of a changed header the first source that includes it.
changed() {
    git diff --name-only --diff-filter=d "$commit" -- 'src/*.cpp' 'tests/*.cpp'
    git diff --name-only --diff-filter=d "$commit" -- 'include/*.h' 'src/*.h' | while read -r header; do
        grep -rlF --include='*.cpp' -- "${header#*/}" src | head -n 1
    done
}
step 'configuring' cmake --preset ci
step 'every source alone' cmake --build --preset ci
mapfile -t sources < <(changed | sort -u | while read -r file; do
    if grep -qF "\"$source/$file\"" build-ci/compile_commands.json; then echo "$file"; fi
done)
if [ "${#sources[@]}" -gt 0 ]; then
    step "clang-tidy on ${#sources[@]} sources" xargs -P "$(nproc)" -n 1 clang-tidy -p build-ci --quiet < <(printf '%s\n' "${sources[@]}")
fi
step 'configuring the sanitizers' cmake --preset ci-asan
step 'building the core modules' cmake --build --preset ci-asan
step 'tests of the core modules' ctest --preset ci-asan
echo "ci: $SECONDS s in all, limit $limit s"
