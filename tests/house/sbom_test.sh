#!/bin/bash
# packaging/sbom.json is what packages.txt, docs/licences.md and web/package-lock.json say, and each part that a release holds has a licence.
# sbom_test.sh SOURCE
. "$(dirname -- "$0")/lib.sh"
command -v python3 >/dev/null || skip 'no python3'
cd "$1"
python3 packaging/sbom.py >"$work/sbom.json"
cmp "$work/sbom.json" packaging/sbom.json || fail 'packaging/sbom.json is old: python3 packaging/sbom.py >packaging/sbom.json'
python3 - "$work/sbom.json" <<'END' || fail 'a part that a release holds has no licence'
import json, sys
parts = json.load(open(sys.argv[1]))["components"]
bare = [p["name"] for p in parts if p["scope"] == "required" and "licenses" not in p and p["properties"][0]["value"] != "python"]
assert len(parts) > 30 and not bare, bare
END
