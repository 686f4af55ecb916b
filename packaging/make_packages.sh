#!/bin/sh
# Debian packages of fusee with the same bytes from any folder (docs/guides/packages.md).
#   packaging/make_packages.sh            builds in build-package/, writes build-package/packages/*.deb
#   packaging/make_packages.sh BUILD      packs what is built in BUILD, into BUILD/packages
set -eu
source=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
cd "$source"
if [ -z "${SOURCE_DATE_EPOCH:-}" ]; then
    SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null) || {
        printf 'make_packages: neither SOURCE_DATE_EPOCH nor a commit states the time of the sources\n' >&2
        exit 2
    }
fi
export SOURCE_DATE_EPOCH
build=${1:-$source/build-package}
if [ $# -eq 0 ]; then
    cmake --preset package
    cmake --build --preset package
fi
packages=$build/packages
rm -rf "$packages"
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$packages"
rm -rf "$packages/_CPack_Packages"
packaging/repack.sh "$packages"/*.deb
ls -l "$packages"
