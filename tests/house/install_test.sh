#!/bin/sh
# What `cmake --install` lays down is complete: a project of its own finds it, links a module and gets the known answer.
# install_test.sh BUILD_FOLDER COMPILER FLAGS [PROGRAM]
. "$(dirname -- "$0")/lib.sh"
consumer=$(cd -- "$(dirname -- "$0")/consumer" && pwd)
prefix="$work/a prefix"
cmake --install "$1" --prefix "$prefix" >"$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; fail 'install (is everything built?)'; }

for file in bash-completion/completions/fusee zsh/site-functions/_fusee fish/vendor_completions.d/fusee.fish man/man1/fusee.1.gz; do
    [ -s "$prefix/share/$file" ] || fail "share/$file was not installed"
done
if [ -n "${4:-}" ]; then
    expect_same 'the installed program' "$("$4" --version)" "$("$prefix/bin/fusee" --version)"
fi
if grep -rn --include='*.cmake' -F "$1" "$prefix" >&2; then fail 'the files above point back into the build folder'; fi

cmake -S "$consumer" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_FLAGS="$3" \
    >"$work/log" 2>&1 || { cat "$work/log" >&2; fail 'find_package(fusee)'; }
cmake --build "$work/build" >"$work/log" 2>&1 || { cat "$work/log" >&2; fail 'the consumer does not build'; }
"$work/build/consumer" || fail 'the consumer got a wrong answer'
