#!/usr/bin/env python3
"""Inputs of other people that once failed, each with its right answer (shared/cases/README.md beside the sources). Prints what is skipped.

shared_cases_test.py PROGRAM SOURCE [FOLDER...]: only these folders. Without FUSEE_LONG_TESTS one servo of each folder is diagnosed. Ends with 77 where the cases are not there. FUSEE_SHARED names another place than SOURCE/../shared.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

program, source = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
cases = pathlib.Path(os.environ.get("FUSEE_SHARED", source.parent / "shared")) / "cases"
LATER = {"designs": "its profiles need one spring alone, a repair of the law and the workshop's rules"}
failures = []
LONG = "FUSEE_LONG_TESTS" in os.environ


class Ended:
    """A run of fusee with --json."""

    def __init__(self, arguments, folder):
        run = subprocess.run([program, *map(str, arguments), "--json"], cwd=folder, capture_output=True, text=True, timeout=300)
        self.code, self.text = run.returncode, run.stdout + run.stderr
        try:
            self.json = json.loads(run.stdout)
        except json.JSONDecodeError:
            self.json = {}

    @property
    def result(self):
        return self.json.get("result") or {}

    def rules(self, *severities):
        """Rules with a finding of these severities, anywhere in the result."""
        return {f["rule"] for f in findings(self.result) if f["severity"] in severities}


def findings(value):
    if isinstance(value, dict):
        if {"rule", "severity"} <= value.keys():
            yield value
        for inner in value.values():
            yield from findings(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from findings(inner)


def expect(what, holds, ended):
    if not holds:
        failures.append(f"{what}\n    exit code {ended.code}\n    " + ended.text[:3000].replace("\n", "\n    "))


CHECKS = {}


def case(function):
    CHECKS[function.__name__] = function
    return function


def diagnose(name, out):
    ended = Ended(["diagnose", cases / name, "--out", out / name.replace("/", "-")], out)
    return ended, ended.result.get("diagnosis", ended.result)


def check(name, out, *options):
    """Of a copy: a checked mesh may get its findings written beside it."""
    copy = out / pathlib.Path(name).name
    copy.write_bytes((cases / name).read_bytes())
    return Ended(["check", copy, *options], out)


@case
def mesh_step(out):
    for name in ("pulley.step", "motor_holder.step"):
        ended = check(f"mesh_step/{name}", out, "--process", "fdm")
        expect(f"{name} is a sound body", ended.code in (0, 1) and not {"mesh.manifold", "mesh.self_intersection"} & ended.rules("error", "not_judged"), ended)
    step, stl = (check(f"mesh_step/motor_holder.{kind}", out, "--process", "fdm") for kind in ("step", "stl"))
    expect("motor_holder has one verdict in STEP and STL", step.rules("error") == stl.rules("error") and step.code == stl.code, step)


@case
def mesh_walls(out):
    for name, errors in (("fb_0.9.stl", set()), ("fb_1.5.stl", set()), ("test_lever_100mm_single.stl", set())):
        ended = check(f"mesh_walls/{name}", out, "--process", "fdm")
        found = {f["rule"]: f["measured"] for f in findings(ended.result) if f["severity"] == "error"}
        expect(f"{name}: an edge is no wall, a rib has a thickness", ended.code in (0, 1) and found.keys() <= errors and "rib of 0.00 mm" not in ended.text, ended)


@case
def mesh_bodies(out):
    for name in ("block_far.stl", "plate_and_block.stl"):
        ended = check(f"mesh_bodies/{name}", out, "--process", "fdm")
        expect(f"{name}: each body is judged by itself", ended.code in (0, 1) and "160" not in str([f for f in findings(ended.result) if "rib" in f["rule"]]), ended)


@case
def csv_dialects(out):
    folder = cases / "csv_dialects"
    expect("m.toml and its law are read", (e := Ended(["check", folder / "m.toml"], out)).code in (0, 1), e)
    expect("ba.csv: semicolons and decimal commas", (e := Ended(["identify", folder / "ba.csv", "--out", "identified"], out)).code == 0, e)
    expect("cat.csv: semicolons and decimal commas",
           (e := Ended(["springs", source / "profiles/pnrvsa.toml", "--catalogue", folder / "cat.csv", "--out", out / "sprung.toml"], out)).code in (0, 1), e)


@case
def servo_held_goals(out):
    for name in ("log200Hz", "control_ramped200Hz")[:2 if LONG else 1]:
        ended, found = diagnose(f"servo_held_goals/{name}", out)
        expect(f"{name}: faultless", ended.code == 0 and found.get("verdict") == "none", ended)
        armature = found.get("build", {}).get("armature", {}).get("value", 0.0)
        expect(f"{name}: armature 0.0203 within 0.0005: {armature}", abs(armature - 0.0203) < 0.0005, ended)


@case
def servo_unknown_gain(out):
    for name in ("noduty", "wrong_x5")[:2 if LONG else 1]:
        ended, found = diagnose(f"servo_unknown_gain/{name}", out)
        expect(f"{name}: no confident answer", ended.code == 0 and found.get("verdict") in ("inconclusive", "unknown", "ambiguous"), ended)
        expect(f"{name}: the figure that decides is doubted", any("duty_per_kp_rad" in doubt for doubt in found.get("doubts", [])), ended)


@case
def servo_armature(out):
    if not LONG:  # ServoFolder.AnyOrderOfFilesGivesTheSameBytes has a small twin
        print("skipped: servo_armature: long form (FUSEE_LONG_TESTS)")
        return
    values = []
    for name in ("none", "none_reordered"):
        ended, found = diagnose(f"servo_armature/{name}", out)
        expect(f"{name}: faultless", ended.code == 0 and found.get("verdict") == "none", ended)
        values.append(found.get("build", {}).get("armature", {}).get("value"))
    expect(f"armature 0.0206 within 4 %, in any order of the files: {values}",
           values[0] is not None and values[0] == values[1] and abs(values[0] / 0.0206 - 1) < 0.04, ended)


@case
def servo_units(out):
    for name, words in (("deg", "degrees"), ("ms", "milliseconds"), ("mass_g", "grams")):
        ended, _ = diagnose(f"servo_units/{name}", out)
        expect(f"{name}: the unit is asked about", ended.code == 2 and words in ended.text and "?" in ended.text, ended)


@case
def pull_one_way(out):
    for name, size in (("asym1_up18", 0.1), ("one_lin_soft5", -0.05), ("lin_loop_scale", 0.1)):
        ended, found = diagnose(f"pull_one_way/{name}", out)
        effects = {effect["id"]: effect["parameter"] for effect in found.get("effects", [])}
        rate = effects.get("law.scale")
        expect(f"{name}: the rate, {size:+.0%}, or ambiguous",
               found.get("verdict") == "ambiguous" or (effects.keys() == {"law.scale"} and rate["ci95"][0] - 0.01 <= size <= rate["ci95"][1] + 0.01), ended)
        expect(f"{name}: no hysteresis from one way", "law.hysteresis" not in effects, ended)


@case
def law_sign(out):
    for name in ("pos_series_sinh", "neg_series_sinh"):
        ended, found = diagnose(f"law_sign/{name}", out)
        effects = found.get("effects", [])
        expect(f"{name}: law.series 3e-4 rad/Nm", len(effects) == 1 and effects[0]["id"] == "law.series"
               and effects[0]["parameter"]["ci95"][0] <= 3e-4 <= effects[0]["parameter"]["ci95"][1], ended)
    ended, found = diagnose("law_sign/neg_both", out)
    expect("neg_both: an answer of the rate", [effect["id"] for effect in found.get("effects", [])] == ["law.scale"], ended)
    ended, found = diagnose("law_sign/mNm", out)
    expect("mNm: the unit is asked about", ended.code == 2 and "mNm" in ended.text and "?" in ended.text, ended)


@case
def identify_one_way(out):
    drive = Ended(["identify", cases / "identify_one_way/drive_only.csv", "--out", "drive"], out)
    expect("drive_only.csv: no friction without a doubt", "torque constant" in drive.text, drive)
    both = Ended(["identify", cases / "identify_one_way/both.csv", "--out", "both"], out)
    expect("both.csv: the torque constant's error is found", both.code == 0 and "torque constant" in both.text.replace("_", " "), both)


def main():
    if not cases.is_dir():
        print(f"SKIP: {cases} is not there")
        return 77
    wanted = sys.argv[3:] or sorted(folder.name for folder in cases.iterdir() if folder.is_dir())
    for name in wanted:
        if name in LATER:
            print(f"skipped: {name}: {LATER[name]}")
        elif name not in CHECKS:
            failures.append(f"{name}: a folder without a check")
        else:
            with tempfile.TemporaryDirectory(prefix="fusee-cases-") as out:
                CHECKS[name](pathlib.Path(out))
            print(f"{name}: tried")
    for failure in failures:
        print(f"FAIL: {failure}", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
