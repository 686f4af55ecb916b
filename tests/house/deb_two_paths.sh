#!/bin/bash
# The Debian packages of the last commit have the same bytes from two folders. Two complete builds: not part of ctest.
# deb_two_paths.sh [SOURCE_FOLDER]
. "$(dirname -- "$0")/lib.sh"
source=$(readlink -f -- "${1:-$(dirname -- "$0")/../..}")
SOURCE_DATE_EPOCH=$(git -C "$source" log -1 --format=%ct)
export SOURCE_DATE_EPOCH CCACHE_DISABLE=1
for place in first another/deeper; do
    mkdir -p "$work/$place"
    git -C "$source" archive HEAD | tar -xf - -C "$work/$place"
    (cd "$work/$place" && packaging/make_packages.sh) >"$work/log" 2>&1 || { tail -n 20 "$work/log" >&2; fail "build in $place"; }
done
for package in "$work"/first/build-package/packages/*.deb; do
    cmp "$package" "$work/another/deeper/build-package/packages/${package##*/}" || fail "${package##*/} differs"
    sha256sum "$package"
done
