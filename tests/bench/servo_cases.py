"""Cases of profiles/models/geared_servo from public measurements, for fusee diagnose (docs/guides/my-simulator-does-not-match.md).

servo_cases.py REAL MODEL OUT   REAL: the folder that FUSEE_GAP_REAL names; MODEL: profiles/models/geared_servo; makes OUT/single,
OUT/pair, OUT/elbow, OUT/elbow_other, OUT/wrist_other

single, pair: one servo and two coupled ones, whose lever two cords pull to and fro (servo_lost_motion_sts3215): first and last row of each
hold. Of the pair the mean of both, each with half of the pull. elbow and the others: one joint of an arm (arm_so101).
"""
import csv
import datetime
import math
import shutil
import sys
from pathlib import Path

COUNT_RAD = 2.0 * math.pi / 4096
PULL_NM = 0.3 * 9.81 * 0.1  # 0.3 kgf at 100 mm
RUNS = 4


def rows_of(file):
    """The rows by column; the first line names the source."""
    return list(csv.DictReader(file.read_text().splitlines()[1:]))


def write_case(model, out, runs, outputs, speed="5.0"):
    """@param runs by file: header and rows"""
    out.mkdir(parents=True, exist_ok=True)
    shutil.copy(model / "model.py", out)
    toml = (model / "case.toml").read_text().split("[experiments.")[0].replace("rad_per_s = {nominal = 5.0}", f"rad_per_s = {{nominal = {speed}}}")
    header = next(iter(runs.values()))[0]
    names = ", ".join(f'"{name}"' for name in runs)
    inputs = ", ".join(f'"{name}"' for name in header[:-1])
    (out / "case.toml").write_text(f"{toml}[experiments.hold]\nfiles = [{names}]\ninputs = [{inputs}]\noutputs = {{angle_rad = {outputs}}}\n")
    for name, (columns, rows) in runs.items():
        lines = [",".join(columns)] + [",".join(f"{value:.6f}" for value in row) for row in rows]
        (out / name).write_text("\n".join(lines) + "\n")


def pulled(real, model, out, file, servos, share):
    """First and last row of each hold; a run begins with the last row of the hold before."""
    rows = [row for row in rows_of(real / "servo_lost_motion_sts3215" / file) if row[f"pos ({servos[0]})"]]

    def mean(row, what):  # the second servo is mounted the other way round
        turns = [float(row[f"{what} ({servo})"]) - 2047 for servo in servos]
        return COUNT_RAD * (turns[0] if len(turns) == 1 else 0.5 * (turns[0] - turns[1]))

    def pull(row):
        return share * PULL_NM * ((float(row["target pos (4)"]) < 2347) - (float(row["target pos (3)"]) > 1747))

    goals = [[row[f"target pos ({servo})"] for servo in (*servos, 3, 4)] for row in rows]
    ends = [i for i in range(len(rows)) if i + 1 == len(rows) or goals[i + 1] != goals[i]]
    holds = [(first, last) for first, last in zip([0] + [end + 1 for end in ends[:-1]], ends) if last - first >= 3]
    runs = {}
    for k in range(RUNS):
        low = max(1, k * len(holds) // RUNS)
        part = [holds[low - 1][1]] + [i for hold in holds[low:(k + 1) * len(holds) // RUNS] for i in hold]
        times = [datetime.datetime.fromisoformat(rows[i]["timestamp"].replace("Z", "+00:00")).timestamp() for i in part]
        begin = mean(rows[part[0]], "pos")
        runs[f"part_{k}.csv"] = (["t_s", "goal_rad", "pull_Nm", "begin_rad", "angle_rad"],
                                 [(t - times[0], mean(rows[i], "target pos"), pull(rows[i]), begin, mean(rows[i], "pos")) for t, i in zip(times, part)])
    write_case(model, out, runs, 0.0015, "0.55")  # 350 steps/s, the speed that the servos report


def joint(real, model, out, file, number, thin, sigma):
    rows = rows_of(real / "arm_so101" / file)[1::thin]
    runs = {}
    for k in range(RUNS):
        part = rows[k * len(rows) // RUNS:(k + 1) * len(rows) // RUNS]
        goal, angle = f"goal_{number}_rad", f"q_{number}_rad"
        runs[f"part_{k}.csv"] = (["t_s", "goal_rad", "begin_rad", "angle_rad"],
                                 [(float(row["t_s"]) - float(part[0]["t_s"]), float(row[goal]), float(part[0][angle]), float(row[angle])) for row in part])
    write_case(model, out, runs, sigma)


def main():
    real, model, out = map(Path, sys.argv[1:4])
    pulled(real, model, out / "single", "single.csv", (5,), 1.0)
    pulled(real, model, out / "pair", "nocomp2.csv", (1, 2), 0.5)
    joint(real, model, out / "elbow", "single_joint_elbow.csv", 2, 4, 0.015)
    joint(real, model, out / "elbow_other", "friction_gravity.csv", 2, 8, 0.015)
    joint(real, model, out / "wrist", "backlash_detection.csv", 4, 8, 0.01)
    joint(real, model, out / "wrist_other", "step_response.csv", 4, 8, 0.01)


if __name__ == "__main__":
    main()
