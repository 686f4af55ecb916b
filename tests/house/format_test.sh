#!/bin/sh
# Every file of include, src, tests and python stands as .clang-format lays it out.
# format_test.sh CLANG_FORMAT [--fix]
. "$(dirname -- "$0")/lib.sh"
cd "$(dirname -- "$0")/../.."
version=$("$1" --version 2>/dev/null) || skip 'no clang-format here'
case $version in *'version 14.'*) ;; *) skip "only Debian 12's clang-format 14 counts, this is $version" ;; esac
if [ "${2:-}" = --fix ]; then action=-i; else action='--dry-run --Werror'; fi
# shellcheck disable=SC2086  # two words
find include src tests python \( -name '*.h' -o -name '*.cpp' \) -exec "$1" --style=file $action {} + >"$work/log" 2>&1 || {
    sed -n 's|:[0-9]*:[0-9]*: error: .*||p' "$work/log" | sort | uniq -c >&2
    fail 'lines to lay out anew in the files above; the target "format" does it'
}
