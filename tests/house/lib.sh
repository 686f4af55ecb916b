# shellcheck shell=sh
# Shared by the house's tests: a folder of their own, and words for what went wrong.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    printf 'FAIL: %s\n' "$*" >&2
    exit 1
}

skip() {
    printf 'SKIP: %s\n' "$*"
    exit 77
}

# expect_same WHAT EXPECTED FOUND
expect_same() {
    [ "$2" = "$3" ] || fail "$1: expected '$2', found '$3'"
}

# expect_in WHAT TEXT FILE
expect_in() {
    grep -qF -- "$2" "$3" || {
        cat "$3" >&2
        fail "$1: '$2' is missing above"
    }
}
