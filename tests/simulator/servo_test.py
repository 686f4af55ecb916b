"""Lost motion of servos and a joint of an arm: a twin whose figures are known, and public measurements, which do not ship.

servo_test.py PROGRAM SOURCE twin|measured
"""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

COUNT_RAD = 2.0 * math.pi / 4096


def diagnosis_of(program, case, out, *options):
    run = subprocess.run([program, "diagnose", case, "--out", out, "--json", *options], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)["result"]["diagnosis"]


def sizes_of(found):
    """Value and 95 % interval of each cause by its id."""
    return {effect["id"]: (effect["parameter"]["value"], *effect["parameter"]["ci95"]) for effect in found["effects"]}


def require_sizes(found, truth, what):
    sizes = sizes_of(found)
    assert found["verdict"] == "identified" and set(sizes) == set(truth), f"{what}: {found['verdict']} {sizes}"
    for cause, true in truth.items():
        value, low, high = sizes[cause]
        print(f"{what}: {cause} {value / COUNT_RAD:.2f} counts ({low / COUNT_RAD:.2f} to {high / COUNT_RAD:.2f}), true {true / COUNT_RAD:.2f}")
        assert low <= true <= high, f"{what}: {cause} {value} ({low} to {high}), not {true}"


def twin(program, source, folder):
    require_sizes(diagnosis_of(program, source / "profiles/models/lost_motion", folder / "out"), {"slack": 0.011, "loaded": 0.023}, "twin")


def measured(program, source, folder):
    real = pathlib.Path(os.environ.get("FUSEE_GAP_REAL", source / "../shared/gap/real"))
    if not (real / "servo_lost_motion_sts3215").is_dir():
        print("skipped: FUSEE_GAP_REAL names no folder of real measurements")
        sys.exit(77)
    subprocess.run([sys.executable, source / "tests/bench/servo_cases.py", real, source / "profiles/models", folder], check=True)
    long = "FUSEE_LONG_TESTS" in os.environ
    for case, slack, loaded in (("lost_single", 7.03, 14.78), ("lost_pair", 6.00, 8.00))[:2 if long else 1]:  # of the authors, in counts
        require_sizes(diagnosis_of(program, folder / case, folder / f"{case}.out"), {"slack": slack * COUNT_RAD, "loaded": loaded * COUNT_RAD}, case)
    if not long:
        return
    found = diagnosis_of(program, folder / "elbow", folder / "elbow.out", "--against", folder / "elbow_other")
    sizes, other = sizes_of(found), found["against"]
    assert found["verdict"] == "identified" and set(sizes) == {"weight", "coulomb"}, f"elbow: neither play nor a delay: {sizes}"
    assert all(cause["survival"] == "agrees" for cause in other["causes"]), other["causes"]
    print(f"elbow: another motion, {other['gap']['before']:.2f} sigma, {other['gap']['carried']:.2f} with the causes carried there")
    assert other["gap"]["carried"] < 0.5 * other["gap"]["before"]


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        {"twin": twin, "measured": measured}[sys.argv[3]](sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(temporary))
