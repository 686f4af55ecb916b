#!/bin/sh
# The pages that the site shows: made from the shipped profile and bench test. samples.sh PROGRAM SOURCE OUT
set -eu
program=$1 source=$2 out=$3
pages=$out/samples work=$out/work
rm -rf -- "$out"
mkdir -p "$pages" "$work"
sed 's/^formats = .*/formats = ["stl"]/' "$source/profiles/pnrvsa.toml" >"$work/pnrvsa.toml"
"$program" --quiet make "$work/pnrvsa.toml" --out "$work" >/dev/null
"$program" --quiet case-template "$work/pnrvsa.toml" --out "$work/monday" >/dev/null
cp "$source"/profiles/examples/bench_monday/*.csv "$work/monday"
"$program" --quiet diagnose "$work/monday" --out "$work/diagnosed" --profile "$work/pnrvsa.toml" >/dev/null
cp "$work/pnrvsa/report.html" "$work/pnrvsa/assembly.html" "$work/pnrvsa/simulation.html" "$work/diagnosed/diagnosis.html" "$pages"
