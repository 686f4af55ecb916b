#!/usr/bin/env python3
"""What the commands cost, beside what they cost before (tests/bench/cost.json). More than a tenth over fails, and says which and by how much.

cost.py PROGRAM [--write]                processor time, as a ratio to reference_work.cpp, which runs in turn: the least of 5 runs of each
cost.py PROGRAM --counts SHIM [--write]  what CI runs: calls of malloc, the same on every machine, busy or not
Allocations count the solids, meshes, files and predictions that are made. A slower inner loop shows in the ratios alone.
"""
import argparse
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SOURCE, KEPT = HERE.parents[1], HERE / "cost.json"
MOST, RUNS = 1.10, 5
COUNTED = {
    "--version": "--version",
    "make, STL": "make stl.toml --out o",
    "batch, a design with meshes": "batch study.toml --out o",
    "check, 13,000 triangles": "check made/pnrvsa/k_pe.stl --process fdm",
    "diagnose, springs and gears": "diagnose parts --out o/d",
}
TIMED = {
    **{name: words for name, words in COUNTED.items() if not name.startswith("check")},
    "make, every format": "make profiles/pnrvsa.toml --out o",
    "check, 131,000 triangles": "check fine/pnrvsa/k_pe.stl --process fdm",
}


def run(program, words, folder, env=None):
    """@return processor time of the command and its children [s]"""
    shutil.rmtree(folder / "o", ignore_errors=True)
    (folder / "o").mkdir()
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ended = subprocess.run([program, *words.split()], cwd=folder, capture_output=True, text=True, env={**os.environ, **(env or {})})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if ended.returncode != 0 and not (ended.returncode == 1 and words.startswith("check ")):  # its findings
        sys.exit(f"{words}: exit code {ended.returncode}: {ended.stdout[-500:]}{ended.stderr[-500:]}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def alone(words):
    return words if words.startswith("--") else words + " --jobs 1"


def lay_inputs(program, folder, timed):
    shutil.copytree(SOURCE / "profiles", folder / "profiles")
    text = re.sub(r"(?m)^formats = .*", 'formats = ["stl"]', (folder / "profiles/pnrvsa.toml").read_text())
    (folder / "stl.toml").write_text(text)
    (folder / "study.toml").write_text('[study]\nbase = "stl.toml"\noutputs = "meshes"\n[vary]\nk_se.hub.bore_mm = [5.5]\n')
    run(program, "make stl.toml --out made", folder)
    if timed:
        (folder / "fine.toml").write_text(re.sub(r"(?m)^chordal_error_mm = .*", "chordal_error_mm = 0.00012", text))
        run(program, "make fine.toml --out fine", folder)
    run(program, "case-template stl.toml --out parts", folder)
    for rows in ("breakaway.csv", "spring_pull.csv"):
        shutil.copy(folder / "profiles/examples/bench_monday" / rows, folder / "parts")
    case = folder / "parts/case.toml"
    case.write_text(re.sub(r"(?m)^(dead_band|joint_stiffness|cocontraction|log) *= .*", "", case.read_text()))


def counts(program, shim, folder):
    found = {}
    for name, words in COUNTED.items():
        file = folder / "counts"
        file.unlink(missing_ok=True)
        run(program, alone(words), folder, {"LD_PRELOAD": shim, "FUSEE_COUNT": str(file)})
        found[name] = sum(map(int, file.read_text().split()))
    return found


def ratios(program, folder):
    reference = str(folder / "reference")
    subprocess.run(["c++", "-std=c++20", "-O2", "-o", reference, HERE / "reference_work.cpp"], check=True)
    found = {}
    for name, words in TIMED.items():
        pairs = [(run(program, alone(words), folder), run(reference, "", folder)) for _ in range(RUNS)]
        found[name] = round(min(time for time, _ in pairs) / min(time for _, time in pairs), 3)
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--counts")
    parser.add_argument("--write", action="store_true")
    wanted = parser.parse_args()
    program, shim = os.path.abspath(wanted.program), wanted.counts and os.path.abspath(wanted.counts)
    with tempfile.TemporaryDirectory(prefix="fusee-cost-") as name:
        folder = pathlib.Path(name)
        lay_inputs(program, folder, not shim)
        kind, found = ("allocations", counts(program, shim, folder)) if shim else ("ratios", ratios(program, folder))
    kept = json.loads(KEPT.read_text()) if KEPT.exists() else {}
    over = [command for command, cost in found.items() if not wanted.write and cost > MOST * kept[kind].get(command, 0)]
    for command, cost in found.items():
        before = kept.get(kind, {}).get(command)
        print(f"{command}: {cost:,} {kind}" + (f", {cost / before - 1:+.1%} of {before:,}" if before else ""))
    if wanted.write:
        KEPT.write_text(json.dumps({**kept, kind: found}, indent=2) + "\n")
    for command in over:
        print(f"COST: {command}: more than a tenth over {KEPT.name}. Mend it, or, where it is meant, write the figures anew with --write", file=sys.stderr)
    return 1 if over else 0


if __name__ == "__main__":
    sys.exit(main())
