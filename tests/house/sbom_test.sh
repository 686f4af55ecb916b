#!/bin/bash
# packaging/sbom.json names what packages.txt, docs/licences.md and web/package-lock.json say, and each library that the program loads while it
# makes every file and picture, with a version and a licence.
# sbom_test.sh SOURCE PROGRAM
. "$(dirname -- "$0")/lib.sh"
command -v python3 >/dev/null || skip 'no python3'
command -v dpkg-query >/dev/null || skip 'not Debian'
source=$1 program=$2
cd "$work"
sed 's/^formats = .*/formats = ["stl", "3mf", "step"]/' "$source/profiles/pnrvsa.toml" >p.toml
# The loader says what it loads, also what libraries load by themselves.
loads() { LD_DEBUG=libs LD_DEBUG_OUTPUT="$work/loads" "$program" "$@" >/dev/null 2>&1 || true; }
loads make p.toml --out o
loads render p.toml --view cams -o cams.png
loads design p.toml --generations 1 --out d
cat loads.* | sed -n 's|.*calling init: \(/[^ ]*\)$|\1|p' | sort -u >files
for library in TKSTEP librsvg cairo; do grep -q "$library" files || fail "no $library was loaded: the runs above do not do what they should"; done
# shellcheck disable=SC2046  # one word per file
python3 "$source/packaging/sbom.py" --check "$program" $(cat files) >wrong ||
    fail "$(cat wrong); python3 packaging/sbom.py PROGRAM >packaging/sbom.json"
