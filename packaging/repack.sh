#!/bin/sh
# Packs Debian packages again, in place, so that equal content has equal bytes: times of SOURCE_DATE_EPOCH, sorted names, owner root, no
# .comment sections. cpack leaves the times at which it copied the files and the order on the disk.
#   packaging/repack.sh PACKAGE.deb...
set -eu
export LC_ALL=C TZ=UTC
: "${SOURCE_DATE_EPOCH:?the time of the sources}"
umask 022
date=$(date -u -R --date="@$SOURCE_DATE_EPOCH")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for package in "$@"; do
    rm -rf "$work/root"
    dpkg-deb --raw-extract "$package" "$work/root"
    find "$work/root" -name '*.a' -exec strip --strip-debug --remove-section=.comment --enable-deterministic-archives {} +
    find "$work/root" -type f \( -path '*/bin/*' -o -name '*.so' \) -exec strip --strip-unneeded --remove-section=.comment {} +
    # cpack asks for ldconfig, which the libraries that fusee loads itself do not need.
    for script in postinst postrm; do
        if grep -qsx '	ldconfig' "$work/root/DEBIAN/$script"; then rm "$work/root/DEBIAN/$script"; fi
    done
    # The changelog has the time of the configuration.
    changelog=$(echo "$work"/root/usr/share/doc/*/changelog.gz)
    zcat "$changelog" | sed "s/^\( -- .*>  \).*/\1$date/" | gzip -9n >"$work/changelog.gz"
    cat "$work/changelog.gz" >"$changelog"
    (cd "$work/root" && find . -path ./DEBIAN -prune -o -type f -printf '%P\n' | sort | xargs -d '\n' md5sum >"$work/md5sums")
    cat "$work/md5sums" >"$work/root/DEBIAN/md5sums"
    find "$work/root" -exec touch --no-dereference --date="@$SOURCE_DATE_EPOCH" {} +
    dpkg-deb --root-owner-group -Zxz -z"${FUSEE_PACKAGE_LEVEL:-9}" --build "$work/root" "$package"
done
