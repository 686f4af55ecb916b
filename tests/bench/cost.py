#!/usr/bin/env python3
"""What the commands cost, beside what they cost before: stored figures (tests/bench/cost.json), or another program. More than a tenth over
fails, and says which and by how much.

cost.py PROGRAM [--write]                processor time, as a ratio to reference_work.cpp, which runs in turn: the least of 5 runs of each
cost.py PROGRAM --counts SHIM [--write]  what CI runs: calls of malloc, the same on every machine, busy or not
cost.py PROGRAM --before COMMIT|PROGRAM [--build] [--runs N] [--most S] [WORDS...]
    Markdown: processor time and peak memory of both programs, run in turn, with the ratios and the goals; a commit is built. WORDS: these
    commands alone, a word each. --build: also the cost of the first command's build, by build_cost.sh; minutes. --most: a command that
    takes more processor time is ended [s]. Exit code 2: a command does not run
cost.py PROGRAM --slopes [designs|triangles|rows|effects...]
    Markdown: processor time over the designs of a study, the triangles of a checked mesh, the rows of a diagnosed table and the
    effects of a simulator, with the exponent from each size to the next
Allocations count the solids, meshes, files and predictions that are made. A slower inner loop shows in the processor time alone.
"""
import argparse
import array
import json
import math
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
MOST, MOST_MEMORY, RUNS, LEAST_S = 1.10, 1.20, 5, 0.02
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
BESIDE = {
    **TIMED,
    "batch, 20 designs with meshes": "batch study_20.toml --out o",
    "batch, a design with every format": "batch study_all.toml --out o",
    "diagnose, one effect": "diagnose bench --out o/d",
    "check, 200,000 triangles": "check torus_316.stl --process fdm",
    "check, 2,000,000 triangles": "check torus_1000.stl --process fdm",
}
BUILD = "the first command's build, in compilations of one corefinement"
# Ratios to commit 12941648, where the goals were set.
GOALS = {"make, STL": 0.29, "make, every format": 0.36, "batch, 20 designs with meshes": 0.33, "diagnose, one effect": 0.5, BUILD: 0.70}


class Ended(Exception):
    """A command ended otherwise than it should."""


def run(program, words, folder, env=None, most=math.inf):
    """@return processor time [s] of the command and its children, inf where it takes more than `most`; peak memory [MB]"""
    shutil.rmtree(folder / "o", ignore_errors=True)
    (folder / "o").mkdir()
    limit = None if most == math.inf else lambda: resource.setrlimit(resource.RLIMIT_CPU, (int(most), int(most) + 5))
    with open(folder / "said", "w+") as said:
        child = subprocess.Popen([program, *words.split()], cwd=folder, stdout=said, stderr=said, preexec_fn=limit,
                                 env={**os.environ, **(env or {})})
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = code = os.waitstatus_to_exitcode(status)
        seconds = usage.ru_utime + usage.ru_stime
        if seconds >= most - 1:
            return math.inf, usage.ru_maxrss / 1024
        if code != 0 and not (code == 1 and words.startswith("check ")):  # its findings
            said.seek(0)
            raise Ended(f"{words}: exit code {code}: {said.read()[-500:]}")
    return seconds, usage.ru_maxrss / 1024


def alone(words):
    return words if words.startswith("--") else words + " --jobs 1"


def lay_torus(path, n):
    """A torus of n x n quads with a finely waved surface, as bench_mesh.h has it, in binary STL."""
    step = 2 * math.pi / n
    points = array.array("f")
    for i in range(n):
        for j in range(n):
            r = 12 + 0.2 * math.sin(7 * i * step) * math.cos(5 * j * step)
            out = 40 + r * math.cos(j * step)
            points.extend((out * math.cos(i * step), out * math.sin(i * step), r * math.sin(j * step)))
    corners = points.tobytes()
    at = [corners[12 * k : 12 * k + 12] for k in range(n * n)]
    with open(path, "wb") as stl:
        stl.write(bytes(80) + (2 * n * n).to_bytes(4, "little"))
        for i in range(n):
            here, there = i * n, (i + 1) % n * n
            for j in range(n):
                k = (j + 1) % n
                a, b, c, d = at[here + j], at[there + j], at[there + k], at[here + k]
                stl.write(b"".join((bytes(12), a, b, c, bytes(14), a, c, d, bytes(2))))


def lay_study(folder, name, base, outputs, n):
    bores = [5.5 + 0.5 * (i / (n - 1) - 0.5) if n > 1 else 5.5 for i in range(n)]
    (folder / f"{name}.toml").write_text(f'[study]\nbase = "{base}"\noutputs = "{outputs}"\n[vary]\nk_se.hub.bore_mm = {bores}\n')


def lay_inputs(program, folder, commands):
    words = " ".join(commands.values())
    shutil.copytree(SOURCE / "profiles", folder / "profiles")
    text = re.sub(r"(?m)^formats = .*", 'formats = ["stl"]', (folder / "profiles/pnrvsa.toml").read_text())
    (folder / "stl.toml").write_text(text)
    lay_study(folder, "study", "stl.toml", "meshes", 1)
    lay_study(folder, "study_20", "stl.toml", "meshes", 20)
    lay_study(folder, "study_all", "profiles/pnrvsa.toml", "all", 1)
    run(program, "make stl.toml --out made", folder)
    if "fine/" in words:
        (folder / "fine.toml").write_text(re.sub(r"(?m)^chordal_error_mm = .*", "chordal_error_mm = 0.00012", text))
        run(program, "make fine.toml --out fine", folder)
    for n in (316, 1000):
        if f"torus_{n}." in words:
            lay_torus(folder / f"torus_{n}.stl", n)
    measured = folder / "profiles/examples/bench_monday"
    if "diagnose bench" in words:
        run(program, "case-template stl.toml --out bench", folder)
        for rows in measured.glob("*.csv"):
            shutil.copy(rows, folder / "bench")
    run(program, "case-template stl.toml --out parts", folder)
    for rows in ("breakaway.csv", "spring_pull.csv"):
        shutil.copy(measured / rows, folder / "parts")
    case = folder / "parts/case.toml"
    case.write_text(re.sub(r"(?m)^(dead_band|joint_stiffness|cocontraction|log) *= .*", "", case.read_text()))


def lay_breakaway(folder, n):
    """Rows of a gear with 0.012 Nm and a tenth of the load as friction, by equation (7) of docs/subsystem-cases.md."""
    (folder / "gear").mkdir(exist_ok=True)
    (folder / "gear/case.toml").write_text('[bench]\nkind = "motor_breakaway"\n[sensors]\ntorque_noise_Nm = 0.002\n[experiments]\n'
                                           'breakaway = "rows.csv"\n')
    with open(folder / "gear/rows.csv", "w") as rows:
        rows.write("side,direction,motor_torque_Nm,load_torque_Nm\n")
        for i in range(n):
            sign, torque = 1 - 2 * (i % 2), 0.1 + 0.9 * (i * 0.618034 % 1)
            load = (torque + sign * 0.012 + 0.002 * math.sin(i)) / (1 - sign * 0.1)
            rows.write(f"agonist,{('drive', 'backdrive')[sign > 0]},{torque:.6f},{load:.6f}\n")


def lay_effects(folder, n):
    """A simulator of y = u + a_1 sin 2u + ... + a_n sin (n + 1)u whose effects are the a; its rows have the first two."""
    shutil.rmtree(folder / "waves", ignore_errors=True)
    (folder / "waves").mkdir()
    (folder / "waves/model.py").write_text('''import json, math, sys
for line in sys.stdin:
    request = json.loads(line)
    p = request["parameters"]
    waves = [(k + 2, p[f"a{k}"]) for k in range(len(p) - 1)]
    y = [p["gain"] * u + sum(a * math.sin(k * u) for k, a in waves) for u in request["inputs"]["u"]]
    print(json.dumps({"id": request["id"], "outputs": {"y": y}}), flush=True)
''')
    (folder / "waves/case.toml").write_text('[model]\ncommand = ["python3", "model.py"]\n[parameters]\ngain = {nominal = 1.0, tolerance = 0.02}\n'
        + "".join(f"a{k} = {{nominal = 0.0}}\n" for k in range(n))
        + "".join(f'[effects.wave_{k}]\nfrees = ["a{k}"]\nusual = 0.05\nrange = [-1.0, 1.0]\nmeaning = "A wave."\n' for k in range(n))
        + '[experiments.sweep]\nfiles = ["0.csv", "1.csv"]\ninputs = ["u"]\noutputs = {y = 0.002}\n')
    for part in range(2):
        u = [(i + 0.5 * part) * 2 * math.pi / 100 for i in range(100)]
        rows = [f"{x:.6f},{x + 0.05 * math.sin(2 * x) - 0.04 * math.sin(3 * x) + 0.002 * math.sin(37 * i * i):.6f}" for i, x in enumerate(u)]
        (folder / f"waves/{part}.csv").write_text("\n".join(["u,y", *rows]) + "\n")


SLOPES = {  # what is counted: sizes, how they are laid, the command
    "designs of a study, with solids and rules": ((10, 20, 40), lambda folder, n: lay_study(folder, "slope", "stl.toml", "figures", n),
                                                 "batch slope.toml --out o"),
    "triangles of a checked mesh": ((200**2, 400**2, 800**2, 1600**2), lambda folder, n: lay_torus(folder / "slope.stl", math.isqrt(n // 2)),
                                    "check slope.stl --process fdm"),
    "rows of a diagnosed break-away test": ((10**3, 10**4, 10**5, 10**6), lay_breakaway, "diagnose gear --out o/d"),
    "effects of a simulator, two of them present": ((4, 8, 16, 32, 64), lay_effects, "diagnose waves --out o/d"),
}


def slopes(program, folder):
    counted = {what.split()[0]: what for what in SLOPES}
    if unknown := [word for word in wanted.words if word not in counted]:
        raise Ended(f"--slopes {unknown[0]}: it knows {', '.join(counted)}")
    chosen = {counted[word]: SLOPES[counted[word]] for word in wanted.words or counted}
    lay_inputs(program, folder, {})
    print("| | count | processor time [s] | exponent |\n|---|---|---|---|")
    for what, (sizes, lay, words) in chosen.items():
        last = None
        for n in sizes:
            lay(folder, n)
            time, _ = run(program, alone(words), folder, most=wanted.most)
            if time == math.inf:
                print(f"| {what} | {n:,} | more than {wanted.most:g} | |", flush=True)
                break
            print(f"| {what} | {n:,} | {time:.2f} |", f"{math.log(time / last[1]) / math.log(n / last[0]):.2f} |" if last else "|", flush=True)
            last = n, time
    return 0


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
        pairs = [(run(program, alone(words), folder)[0], run(reference, "", folder)[0]) for _ in range(RUNS)]
        found[name] = round(min(time for time, _ in pairs) / min(time for _, time in pairs), 3)
    return found


def build(source, folder):
    """@return the program of a source tree; its launcher installs the packages that it asks for"""
    for words in (["env", f"FUSEE_BUILD_DIR={folder}", f"{source}/fusee", "--version"],
                  ["cmake", "-S", source, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DFUSEE_BUILD_TESTS=OFF"],
                  ["cmake", "--build", folder, "--target", "fusee_app"]):
        done = subprocess.run(words, capture_output=True, text=True)
        if done.returncode:
            raise Ended(f"{words}: {done.stdout[-3000:]}{done.stderr[-3000:]}")
    return str(folder / "bin/fusee")


def units(source):
    """@return cost of the first command's build [compilations of one corefinement]"""
    said = subprocess.run([HERE / "build_cost.sh", "first", source], capture_output=True, text=True, check=True).stdout
    return float(re.search(r"costs ([\d.]+) times", said)[1])


def row(name, before, after):
    """One line of the table. @param before, after (time, memory) @return is it a tenth slower, or a fifth larger?"""
    (time, memory), (now, memory_now) = before, after
    text = [f"more than {wanted.most:g}" if one == math.inf else f"{one:.3f}" for one in (time, now)]
    ratio = now / time if math.inf not in (time, now) else 0.0 if now < math.inf else 1.0 if time == math.inf else math.inf
    sizes = [f"{memory:.0f}", f"{memory_now:.0f}", f"{memory_now / memory:.2f}"] if memory else [""] * 3
    print("|", " | ".join([f"`{name}`", *text, f"{ratio:.2f}", f"{GOALS[name]:.2f}" if name in GOALS else "", *sizes]), "|", flush=True)
    return (ratio > MOST and now > time + LEAST_S) or memory_now > MOST_MEMORY * memory


def beside(after, folder):
    """@return the exit code"""
    commit, before, trees = wanted.before, wanted.before, None
    if not os.path.exists(before):
        if subprocess.run(["git", "-C", SOURCE, "rev-parse", "--verify", "--quiet", f"{commit}^{{commit}}"], capture_output=True).returncode:
            raise Ended(f"--before {commit}: neither a program nor a commit of {SOURCE}")
        tree = folder / "tree"
        subprocess.run(["git", "-C", SOURCE, "worktree", "add", "--quiet", "--detach", tree, commit], check=True)
        trees = (tree, SOURCE)
        before = build(tree, folder / "build")
    before = os.path.abspath(before)
    commands = {words: words for words in wanted.words} or {name: alone(words) for name, words in BESIDE.items()}
    if not wanted.words:
        lay_inputs(after, folder, commands)
    print("| | before [s] | after [s] | ratio | goal | memory before [MB] | after [MB] | ratio |\n|---|---|---|---|---|---|---|---|")
    over = 0
    for name, words in commands.items():
        found = ([], [])
        for _ in range(wanted.runs):
            for side, program in enumerate((before, after)):  # in turn, so that a busy moment meets both
                if not found[side] or found[side][-1][0] < wanted.most / 10:  # what takes long runs once
                    try:
                        found[side].append(run(program, words, folder, most=wanted.most))
                    except Ended as ended:
                        raise Ended(f"{('before', 'after')[side]} {ended}") from ended
        over |= row(name, *((min(t for t, _ in one), max(m for _, m in one)) for one in found))
    if wanted.build and trees:
        over |= row(BUILD, *((units(tree), 0) for tree in trees))
    return int(over)


def beside_stored(program, shim, folder):
    """@return the exit code"""
    lay_inputs(program, folder, COUNTED if shim else TIMED)
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


def main():
    program, shim = os.path.abspath(wanted.program), wanted.counts and os.path.abspath(wanted.counts)
    with tempfile.TemporaryDirectory(prefix="fusee-cost-") as name:
        try:
            folder = pathlib.Path(name)
            if wanted.slopes:
                return slopes(program, folder)
            return beside(program, folder) if wanted.before else beside_stored(program, shim, folder)
        except (Ended, OSError) as ended:
            print(f"failed: {ended}", file=sys.stderr)
            return 2
        finally:
            subprocess.run(["git", "-C", SOURCE, "worktree", "remove", "--force", f"{name}/tree"], capture_output=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("words", nargs="*")
    parser.add_argument("--counts")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--before")
    parser.add_argument("--slopes", action="store_true")
    parser.add_argument("--build", action="store_true")
    parser.add_argument("--runs", type=int, default=RUNS)
    parser.add_argument("--most", type=float, default=300.0)
    wanted = parser.parse_intermixed_args()
    sys.exit(main())
