#!/bin/bash
# The exported files of every shipped profile are the ones of tests/golden/exports.sha256, byte for byte but for the stamp (version, profile
# hash) that they carry. Left out: reports, simulation pages and drawings, which change with their wording.
# exports_test.sh PROGRAM SOURCE [update]: "update" writes the hashes anew, for a change that is meant.
. "$(dirname -- "$0")/../house/lib.sh"
program=$1 source=$2
golden=$source/tests/golden/exports.sha256
stamp='s/fusee [0-9][0-9.]*/fusee VERSION/g;s/profile [0-9a-f]\{12\}/profile HASH/g;s/"sha256": "[0-9a-f]*"/"sha256": "HASH"/g'
stamp+=';s/"profile_sha256": "[0-9a-f]*"/"profile_sha256": "HASH"/g;s/UUID="[-0-9a-f]*"/UUID="ID"/g'

# The profiles whose hashes are stored: a user's own profile beside them is none of these.
mapfile -t profiles < <(sed "s|.* \./\([^/]*\)/.*|$source/profiles/\1.toml|" "$golden" | LC_ALL=C sort -u)
# That of G-code for a printed part is asked for here: no shipped profile of fdm has it.
sed '/^formats = /s/"step"/"step", "ngc"/' "$source/profiles/pnrvsa.toml" >"$work/pnrvsa.toml"
profiles=("${profiles[@]/#"$source/profiles/pnrvsa.toml"/"$work/pnrvsa.toml"}")
"$program" make "${profiles[@]}" --out "$work/out" >"$work/log" 2>&1 || {
    cat "$work/log" >&2
    fail 'a shipped profile cannot be made'
}
cd "$work/out"
find . -type f -regex '.*\.\(stl\|scad\|dxf\|3mf\|step\|ngc\|csv\)' -o -name 'k_*.json' -o -name plate.json | LC_ALL=C sort | while IFS= read -r file; do
    case $file in
        *.3mf) # a zip: its members are compared
            mkdir "$work/unzipped"
            (cd "$work/unzipped" && cmake -E tar xf "$work/out/$file" && find . -type f | LC_ALL=C sort | xargs -d '\n' cat)
            rm -r "$work/unzipped"
            ;;
        *) cat "$file" ;;
    esac | LC_ALL=C sed "$stamp" | sha256sum | sed "s|-\$|$file|"
done >"$work/found"
if [ "${3:-}" = update ]; then
    cp "$work/found" "$golden"
    exit 0
fi
diff "$golden" "$work/found" >"$work/diff" || {
    grep '^[<>]' "$work/diff" | sed 's/^\(.\) [0-9a-f]*/\1/' >&2
    fail 'these exports have changed. If that is meant: tests/golden/exports_test.sh PROGRAM SOURCE update'
}
printf '%s files as before\n' "$(wc -l <"$golden")"
