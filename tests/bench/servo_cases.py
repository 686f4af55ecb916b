"""Cases from public measurements of servos, for fusee diagnose (docs/guides/my-simulator-does-not-match.md).

servo_cases.py REAL MODELS OUT   REAL: the folder that FUSEE_GAP_REAL names; MODELS: profiles/models; makes OUT/single, OUT/pair, OUT/elbow,
OUT/elbow_other, OUT/wrist, OUT/wrist_other of geared_servo, and OUT/lost_single, OUT/lost_pair of lost_motion

single, pair: one servo and two coupled ones, whose lever two cords pull to and fro (servo_lost_motion_sts3215): first and last row of each
hold. Of the pair the mean of both, each with half of the pull. lost_single, lost_pair: the last row of each hold at the middle goal, from
the first pull there on. elbow and the others: one joint of an arm (arm_so101).
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
    """@param runs by file: header, with the outputs last, and rows @param outputs standard deviation of each"""
    out.mkdir(parents=True, exist_ok=True)
    shutil.copy(model / "model.py", out)
    toml = (model / "case.toml").read_text().split("[experiments.")[0].replace("rad_per_s = {nominal = 5.0}", f"rad_per_s = {{nominal = {speed}}}")
    header = next(iter(runs.values()))[0]
    names = ", ".join(f'"{name}"' for name in runs)
    inputs = ", ".join(f'"{name}"' for name in header if name not in outputs)
    sigmas = ", ".join(f"{name} = {sigma}" for name, sigma in outputs.items())
    (out / "case.toml").write_text(f"{toml}[experiments.hold]\nfiles = [{names}]\ninputs = [{inputs}]\noutputs = {{{sigmas}}}\n")
    for name, (columns, rows) in runs.items():
        lines = [",".join(columns)] + [",".join(f"{value:.6f}" for value in row) for row in rows]
        (out / name).write_text("\n".join(lines) + "\n")


class Pulled:
    """Rows of one servo or two coupled ones while two cords pull their lever to and fro."""

    def __init__(self, file, servos):
        self.servos = servos
        self.rows = [row for row in rows_of(file) if row[f"pos ({servos[0]})"]]
        goals = [[row[f"target pos ({servo})"] for servo in (*servos, 3, 4)] for row in self.rows]
        ends = [i for i in range(len(goals)) if i + 1 == len(goals) or goals[i + 1] != goals[i]]
        self.holds = [(first, last) for first, last in zip([0] + [end + 1 for end in ends[:-1]], ends) if last - first >= 3]

    def angles(self, i, what="pos"):
        """Of each servo [rad]; the second one is mounted the other way round."""
        turns = [COUNT_RAD * (float(self.rows[i][f"{what} ({servo})"]) - 2047) for servo in self.servos]
        return [turns[0]] + [-turn for turn in turns[1:]]

    def mean(self, i, what="pos"):
        return sum(self.angles(i, what)) / len(self.servos)

    def pull(self, i):
        return PULL_NM * ((float(self.rows[i]["target pos (4)"]) < 2347) - (float(self.rows[i]["target pos (3)"]) > 1747))

    def time(self, i):
        return datetime.datetime.fromisoformat(self.rows[i]["timestamp"].replace("Z", "+00:00")).timestamp()


def pulled(own, model, out, share):
    """First and last row of each hold; a run begins with the last row of the hold before."""
    runs = {}
    for k in range(RUNS):
        low = max(1, k * len(own.holds) // RUNS)
        part = [own.holds[low - 1][1]] + [i for hold in own.holds[low:(k + 1) * len(own.holds) // RUNS] for i in hold]
        begin = own.mean(part[0])
        runs[f"part_{k}.csv"] = (["t_s", "goal_rad", "pull_Nm", "begin_rad", "angle_rad"],
                                 [(own.time(i) - own.time(part[0]), own.mean(i, "target pos"), share * own.pull(i), begin, own.mean(i)) for i in part])
    write_case(model, out, runs, {"angle_rad": 0.0015}, "0.55")  # 350 steps/s, the speed that the servos report


def lost_motion(own, model, out):
    """Last row of each hold after a pull at this goal."""
    held, pulls = [], False
    for _, last in own.holds:
        pulls = own.mean(last, "target pos") == 0.0 and (pulls or own.pull(last) != 0.0)
        if pulls:
            held.append(last)
    names = ["first_rad", "second_rad"][:len(own.servos)]
    runs = {}
    for k in range(RUNS):
        part = held[k * len(held) // RUNS:(k + 1) * len(held) // RUNS]
        part = part[next(n for n, i in enumerate(part) if own.pull(i) != 0.0):]
        runs[f"part_{k}.csv"] = (["t_s", "goal_rad", "pull_Nm", *names],
                                 [(own.time(i) - own.time(part[0]), 0.0, own.pull(i), *own.angles(i)) for i in part])
    write_case(model, out, runs, dict.fromkeys(names, 0.0015))  # one count


def joint(real, model, out, file, number, thin, sigma):
    rows = rows_of(real / "arm_so101" / file)[1::thin]
    runs = {}
    for k in range(RUNS):
        part = rows[k * len(rows) // RUNS:(k + 1) * len(rows) // RUNS]
        goal, angle = f"goal_{number}_rad", f"q_{number}_rad"
        runs[f"part_{k}.csv"] = (["t_s", "goal_rad", "begin_rad", "angle_rad"],
                                 [(float(row["t_s"]) - float(part[0]["t_s"]), float(row[goal]), float(part[0][angle]), float(row[angle])) for row in part])
    write_case(model, out, runs, {"angle_rad": sigma})


def main():
    real, models, out = map(Path, sys.argv[1:4])
    model, servos = models / "geared_servo", real / "servo_lost_motion_sts3215"
    single, pair = Pulled(servos / "single.csv", (5,)), Pulled(servos / "nocomp2.csv", (1, 2))
    pulled(single, model, out / "single", 1.0)
    pulled(pair, model, out / "pair", 0.5)
    lost_motion(single, models / "lost_motion", out / "lost_single")
    lost_motion(pair, models / "lost_motion", out / "lost_pair")
    joint(real, model, out / "elbow", "single_joint_elbow.csv", 2, 4, 0.015)
    joint(real, model, out / "elbow_other", "friction_gravity.csv", 2, 8, 0.015)
    joint(real, model, out / "wrist", "backlash_detection.csv", 4, 8, 0.01)
    joint(real, model, out / "wrist_other", "step_response.csv", 4, 8, 0.01)


if __name__ == "__main__":
    main()
