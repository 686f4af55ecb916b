#!/bin/bash
# The bundles in web/built are those of their sources: by the hash of the sources that each carries, and with "rebuild" byte for byte.
# web_test.sh SOURCE [rebuild]
. "$(dirname -- "$0")/lib.sh"
cd "$1/web"

hash=$({ printf '%s\n' build.mjs package-lock.json package.json; find src -type f; } | LC_ALL=C sort | xargs sha256sum | sha256sum | cut -d ' ' -f 1)
for file in page.js page.css joint.js joint.css; do
    head -n 1 "built/$file" >"$work/head"
    expect_in "web/built/$file is not current; in web: npm ci && npm run build" "sources sha256:$hash " "$work/head"
done
if grep -q '"resolved"' package-lock.json; then fail 'web/package-lock.json names a registry'; fi
[ "${2-}" = rebuild ] || exit 0

command -v npm >/dev/null || skip 'npm is not installed: only the hash of the sources was compared (house.web), not the bundles'
cp -r build.mjs package.json package-lock.json .npmrc src "$work"
mkdir "$work/built"
(cd "$work" && timeout 120 npm ci >npm.log 2>&1) || skip 'npm ci failed, without its registry: only the hash of the sources was compared'
(cd "$work" && npm run build >npm.log 2>&1) || { cat "$work/npm.log"; fail 'npm run build'; }
for file in built/*; do cmp "$file" "$work/$file" || fail "web/$file is not what its sources give"; done
