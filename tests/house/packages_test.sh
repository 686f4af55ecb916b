#!/bin/bash
# packages.txt is complete: every library header that a source includes belongs to a package of that list, and each is installed.
# packages_test.sh SOURCE_FOLDER
. "$(dirname -- "$0")/lib.sh"
cd "$1"
command -v dpkg-query >/dev/null || skip 'not a Debian system'
# Those of the site are for ./fusee site, which installs them. MuJoCo may be missing: its tests are skipped then.
mapfile -t wanted < <(sed '/^# site:/,/^#/d; /^# mujoco:/,+1d; /^# siconos:/,+1d' packages.txt | sed 's/#.*//; /^[[:space:]]*$/d; s/[[:space:]]//g')
dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${wanted[@]}" >"$work/status" || fail 'a package of packages.txt is not known'
while read -r package status; do  # a program of another origin will do
    [ "$status" = installed ] || command -v "$package" >/dev/null || fail "$package is not installed"
done <"$work/status"

# The standard library and the system come with build-essential; libboost-dev and its like only point to a version of themselves.
dpkg-query -W -f='${Package}\n${Depends}\n' "${wanted[@]}" | tr ',|' '\n' | sed 's/^ *//; s/[ :].*//' | sort -u >"$work/provided"
sed -n '/^# mujoco:/{n;p}; /^# siconos:/{n;p}' packages.txt >>"$work/provided"
grep -rhoP --include='*.h' --include='*.cpp' '^\s*#\s*include\s*<\K[^>]+' include src tests python | sort -u >"$work/included"
roots=(/usr/include /usr/include/eigen3 /usr/include/lib3mf /usr/include/dxflib /usr/include/librsvg-2.0 /usr/include/cairo)
while read -r header; do
    for root in "${roots[@]}"; do
        if [ -e "$root/$header" ]; then readlink -f "$root/$header"; break; fi
    done
done <"$work/included" >"$work/files"
[ -s "$work/files" ] || fail 'no library header was found at all'
xargs dpkg-query -S <"$work/files" | sed 's/[:,].*//' | sort -u >"$work/owners"
while read -r owner; do
    case $owner in libc6-dev | linux-libc-dev | libstdc++-*) continue ;; esac
    grep -qxF -- "$owner" "$work/provided" || fail "$owner is included from, but is not in packages.txt"
done <"$work/owners"

# docs/licences.md has a row for each library.
sed -n '/^# libraries:/,/^# tests:/{/^#/d;p}' packages.txt >"$work/libraries"
[ -s "$work/libraries" ] || fail 'packages.txt has no libraries'
while read -r library; do
    grep -qF -- "\`$library\`" docs/licences.md || fail "$library is not in docs/licences.md"
done <"$work/libraries"
