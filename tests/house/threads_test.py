#!/usr/bin/env python3
"""1 = 7 threads (and 2 in the long form), byte for byte, for every command that has --jobs: files and standard output.

threads_test.py PROGRAM SOURCE [--long]
"""
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SHORT = {
    "make": "make fast.toml other.toml --out o",
    "simulate": "simulate profiles/relatives --levels 3 --out o",
    "design": "design fast.toml --generations 3 --out o",
    "batch": "batch study.toml --out o",
    "diagnose": "diagnose parts --out o/diagnosis",
    "blind make": "blind make --seed 1 --cases 3 --out o/blind",
    "check": "check fast.toml --process all",
}
LONG = {
    "make, every format": "make profiles/pnrvsa.toml --out o",
    "design, co-design": "design profiles/pnrvsa_co_design.toml --generations 3 --out o",
    "blind score": "blind score bench --limit 1 --out o",
    "diagnose, a simulator": "diagnose profiles/models/cam_spring --out o/diagnosis",
    "diagnose, first table": "diagnose profiles/gap/paper_table_1 --out o/diagnosis",
    "diagnose, second table": "diagnose profiles/gap/paper_table_2 --out o/diagnosis",
    "paper": "paper --profiles profiles --out o",
}
TIMES = re.compile(r"(?<= )[ 0-9]{3}\.[0-9]{2} s\b|[0-9.]+ s\b|[0-9.]+ designs/s")  # first the table's column of 6 characters
SCORE_TIMES = re.compile(rb'"seconds":\s*\{[^}]*\}|(median|worst) [0-9.]+ s\b')  # of a blind score: the program's own times
SKIPPED = re.compile(r"rows/|index\.sqlite|\.fusee\.json$|held_out\.json$")  # hold times, or a database's pages


def digest(file):
    content = file.read_bytes()
    return hashlib.sha256(SCORE_TIMES.sub(b"", content) if file.stem == "score" else content).hexdigest()


def result(program, folder, words, jobs):
    (folder / "o").mkdir()
    extra = ["--jobs", str(jobs)]
    ended = subprocess.run([program, *words.split(), *extra], cwd=folder, capture_output=True, text=True, timeout=1500)
    files = {str(p.relative_to(folder / "o")): digest(p) for p in sorted((folder / "o").rglob("*"))
             if p.is_file() and not SKIPPED.search(str(p))}
    subprocess.run(["rm", "-rf", folder / "o", folder / "bench/diagnoses"], check=True)
    return ended.returncode, TIMES.sub("? s", ended.stdout), files, ended.stderr


def main():
    program, source = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    commands = {**SHORT, **LONG} if "--long" in sys.argv else SHORT
    wrong = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run(["cp", "-r", source / "profiles", folder / "profiles"], check=True)
        text = re.sub(r"(?m)^formats = .*", 'formats = ["stl", "3mf"]', (folder / "profiles/pnrvsa.toml").read_text())
        text = re.sub(r"(?m)^chordal_error_mm = .*", "chordal_error_mm = 0.005", text)
        (folder / "fast.toml").write_text(text)
        (folder / "other.toml").write_text(text.replace('name = "pnrvsa"', 'name = "other"').replace("preload_rad = 3.7", "preload_rad = 3.71"))
        (folder / "study.toml").write_text(
            '[study]\nbase = "fast.toml"\noutputs = "figures"\n[vary]\nk_se.hub.bore_mm = {from = 5.0, to = 6.0, steps = 4}\n')
        # The parts alone of an example: every stage of a diagnosis in a third of the time of the paper's tables.
        subprocess.run([program, "case-template", "fast.toml", "--out", "parts"], cwd=folder, check=True, capture_output=True)
        for rows in ("breakaway.csv", "spring_pull.csv"):
            shutil.copy(folder / "profiles/examples/bench_monday" / rows, folder / "parts")
        case = folder / "parts/case.toml"
        case.write_text(re.sub(r"(?m)^(dead_band|joint_stiffness|cocontraction|log) *= .*", "", case.read_text()))
        if "--long" in sys.argv:
            subprocess.run([program, "blind", "make", "--seed", "3", "--cases", "1", "--out", "bench"], cwd=folder, check=True,
                           capture_output=True)
        for command, words in commands.items():
            one = result(program, folder, words, 1)
            if one[0] not in (0, 1) or (not one[2] and not one[1]):
                wrong.append(f"{command}: exit code {one[0]}: {one[3][-400:]}")
                continue
            before = len(wrong)
            for jobs in (2, 7) if commands is not SHORT else (7,):
                other = result(program, folder, words, jobs)
                if other[:3] != one[:3]:
                    names = [n for n in {**one[2], **other[2]} if one[2].get(n) != other[2].get(n)]
                    wrong.append(f"{command}: {jobs} threads differ from 1: exit codes {one[0]}, {other[0]}; files {names[:5]}; "
                                 f"{'output differs' if one[1] != other[1] else ''}")
            print(f"{command}: {len(one[2])} files, {len(one[1])} characters of output: as with one thread" if len(wrong) == before else command, flush=True)
    for line in wrong:
        print(f"WRONG: {line}", file=sys.stderr)
    return 1 if wrong else 0


sys.exit(main())
