#!/usr/bin/env python3
"""Diagnoses of blind cases from one experiment alone and from each pair: how far do few data go? (docs/benchmark.md)

subsets.py PROGRAM BENCHMARK OUT SINGLES PAIRS

BENCHMARK: a folder of `fusee blind make`. Its first SINGLES cases without effect or with one of the library are diagnosed from each experiment
alone, its first PAIRS from each pair. OUT/rows.jsonl gets a row for each answer; a run that was stopped goes on there. The table is printed.
Exit code 1: a diagnosis failed, or called a rig with an effect `none`.
"""
import base64, collections, itertools, json, pathlib, shutil, subprocess, sys

EXPERIMENTS = ("breakaway", "spring_pull", "dead_band", "joint_stiffness", "cocontraction", "log")
ANSWERS = ("right", "inconclusive", "truth among alternatives", "unknown", "wrong", "missed", "failed")


def part_of(case, folder, experiments):
    """The case with these experiments alone."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    toml = (case / "case.toml").read_text()
    listed = "".join(f'{name} = "{name}.csv"\n' for name in experiments)
    (folder / "case.toml").write_text(toml[: toml.index("[experiments]")] + "[experiments]\n" + listed)
    for name in ("nominal_springs", *experiments):
        shutil.copy(case / f"{name}.csv", folder)


def effects_of(answer):
    return sorted((effect["id"], effect["side"]) for effect in answer["effects"])


def judge(truth, answer):
    verdict, named = answer["verdict"], effects_of(answer)
    if verdict in ("inconclusive", "unknown"):
        return verdict
    if verdict == "none":
        return "missed" if truth else "right"
    if named == truth:
        return "right"
    return "truth among alternatives" if truth in [effects_of(other) for other in answer["alternatives"]] else "wrong"


def answer_of(program, case, work, experiments, truth):
    part_of(case, work / "case", experiments)
    ended = subprocess.run([program, "diagnose", work / "case", "--out", work / "out", "--jobs", "1", "-q"], capture_output=True, text=True)
    if ended.returncode:
        return {"answer": "failed", "why": ended.stderr[-300:]}
    answer = json.loads((work / "out/diagnosis.json").read_text())
    return {"answer": judge(truth, answer), "named": effects_of(answer)}


def table(rows):
    counts = collections.defaultdict(collections.Counter)
    for row in rows:
        counts[", ".join(row["experiments"])][row["answer"]] += 1
    lines = ["| experiments | cases | " + " | ".join(ANSWERS) + " |", "|---" * (len(ANSWERS) + 2) + "|"]
    lines += [f"| {name} | {sum(of.values())} | " + " | ".join(str(of[answer]) for answer in ANSWERS) + " |" for name, of in counts.items()]
    return "\n".join(lines)


def main():
    program, bench, out = (pathlib.Path(a).resolve() for a in sys.argv[1:4])
    singles, pairs = int(sys.argv[4]), int(sys.argv[5])
    labels = json.loads(base64.b64decode((bench / "labels.sealed").read_text()))["labels"]
    labels = [label for label in labels if label["in_library"] and len(label["effects"]) < 2]
    todo = [((name,), label) for label in labels[:singles] for name in EXPERIMENTS]
    todo += [(pair, label) for label in labels[:pairs] for pair in itertools.combinations(EXPERIMENTS, 2)]
    out.mkdir(parents=True, exist_ok=True)
    file = out / "rows.jsonl"
    rows = [json.loads(line) for line in file.read_text().splitlines()] if file.exists() else []
    done = {(tuple(row["experiments"]), row["case"]) for row in rows}
    with file.open("a") as log:
        for experiments, label in todo:
            if (experiments, label["case"]) in done:
                continue
            truth = effects_of(label)
            row = {"experiments": experiments, "case": label["case"], "truth": truth}
            row |= answer_of(program, bench / label["case"], out / "work", experiments, truth)
            rows.append(row)
            log.write(json.dumps(row) + "\n")
            log.flush()
    shutil.rmtree(out / "work", ignore_errors=True)
    print(table(rows))
    return 1 if not rows or any(row["answer"] in ("failed", "missed") for row in rows) else 0


sys.exit(main())
