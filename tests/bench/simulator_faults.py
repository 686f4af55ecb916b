"""Sealed faults of the example simulators: does fusee diagnose name them, and does it name none where there is none?

simulator_faults.py PROGRAM MODELS MODEL SEED COUNT   COUNT faulty and COUNT faultless cases; a line a case on standard error, the score as JSON
simulator_faults.py --ship PROGRAM MODELS MODEL       writes the runs that ship with an example

PROGRAM: fusee; a model of MuJoCo is measured by fusee-mujoco beside it. The truth has its own figures (each within its tolerance), a fault, and noise; the label is looked at after the diagnosis alone.
"""
import functools
import importlib.util
import json
import math
import random
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROWS, STEP_S = 200, 0.02
FEWER_ROWS = {"mujoco_arm": 120, "lost_motion": 32}

# Faults by model: effect or parameter or port, least and greatest size (of a port or effect in its unit, of a parameter in tolerances).
FAULTS = {
    "series_elastic": {
        "motor_coulomb": (0.05, 0.25), "play": (0.01, 0.06), "hardening": (1.5, 8.0),
        "spring_Nm_per_rad": (7, 15), "link_inertia_kgm2": (7, 15), "motor_inertia_kgm2": (8, 15),
        "port.link_rad.offset": (0.02, 0.2), "port.link_rad.delay": (0.01, 0.05), "port.motor_rad.scale": (0.03, 0.1),
        "port.torque_Nm.dead_zone": (0.05, 0.2), "port.link_rad.drift": (0.02, 0.2)},
    "geared_pendulum": {
        "coulomb": (0.02, 0.12), "load_friction": (0.05, 0.3), "cogging": (0.02, 0.08),
        "length_m": (7, 15), "torque_constant_Nm_per_A": (7, 12),
        "port.angle_rad.offset": (0.02, 0.2), "port.angle_rad.delay": (0.01, 0.05), "port.current_A.offset": (0.02, 0.2),
        "port.voltage_V.dead_zone": (0.1, 0.5), "port.current_A.scale": (0.04, 0.15), "port.angle_rad.drift": (0.03, 0.2)},
    "cam_spring": {
        "slide_friction": (0.03, 0.2), "bearing_friction": (0.02, 0.1), "hardening": (2.0, 10.0),
        "lift_m": (8, 20), "rate_N_per_m": (7, 12), "preload_m": (7, 15),
        "port.angle_rad.offset": (0.02, 0.15), "port.torque_Nm.offset": (0.02, 0.1), "port.torque_Nm.scale": (0.03, 0.1),
        "port.force_N.scale": (0.03, 0.1), "port.force_N.drift": (1.0, 5.0), "port.torque_Nm.delay": (0.02, 0.1)},
    "geared_servo": {
        "coulomb": (0.05, 0.2), "load_friction": (0.1, 0.6), "play": (0.01, 0.06), "weight": (0.1, 0.6),
        "stiffness_Nm_per_rad": (6, 12), "damping_Nms": (6, 12),
        "port.angle_rad.offset": (0.01, 0.1), "port.angle_rad.delay": (0.02, 0.1), "port.angle_rad.drift": (0.01, 0.1),
        "port.goal_rad.delay": (0.02, 0.1), "port.goal_rad.scale": (0.04, 0.15), "port.pull_Nm.scale": (0.3, 1.0)},
    "lost_motion": {
        "slack": (0.006, 0.03), "loaded": (0.006, 0.05), "port.goal_rad.scale": (0.05, 0.3), "port.goal_rad.offset": (0.02, 0.1),
        "port.first_rad.scale": (0.05, 0.3), "port.second_rad.scale": (0.05, 0.3), "port.second_rad.drift": (0.01, 0.05)},
    "mujoco_arm": {
        "elbow_frictionloss_Nm": (0.05, 0.3), "shoulder_stiffness_Nm_per_rad": (0.5, 3.0), "elbow_stiffness_Nm_per_rad": (0.3, 1.5),
        "shoulder_frictionloss_Nm": (8, 20), "elbow_damping_Nms": (8, 20), "upper_mass_kg": (8, 20), "fore_mass_kg": (10, 40),
        "elbow_kp_Nm_per_rad": (6, 12), "port.shoulder_rad.offset": (0.02, 0.1), "port.elbow_rad.scale": (0.04, 0.15),
        "port.elbow_rad.delay": (0.02, 0.08), "port.elbow_goal_rad.delay": (0.03, 0.1), "port.elbow_torque_Nm.scale": (0.1, 0.4),
        "port.shoulder_goal_rad.dead_zone": (0.03, 0.15)},
}
SHIPPED = {"series_elastic": [("motor_coulomb", 0.12)], "geared_pendulum": [("port.angle_rad.delay", 0.03)], "cam_spring": [("lift_m", 10)],
           "geared_servo": [("coulomb", 0.1)], "lost_motion": [("slack", 0.011), ("loaded", 0.023)],
           "mujoco_arm": [("elbow_frictionloss_Nm", 0.15)]}
ONE_SIDED = ("coulomb", "slack", "loaded", "play", "load_friction", "slide_friction", "bearing_friction", "hardening", ".delay", ".dead_zone", "frictionloss_Nm",
             "stiffness_Nm_per_rad", "damping_Nms")  # ends of the names of what has no sign, or would lose its own


def square(time, period):
    """1, 0, -1, 0 in turn."""
    return [(1.0, 0.0, -1.0, 0.0)[int(4.0 * t / period) % 4] for t in time]


def servo_inputs(file, time):
    """What the servo shall do and what pulls it; a run begins where the goal is."""
    wave = [math.sin(2.0 * math.pi * 0.5 * t) for t in time]
    goal, pull = {
        "pulls.csv": ([0.0] * len(time), [0.3 * value for value in square(time, 1.6)]),
        "swing.csv": ([0.3 * value for value in wave], [0.2 if value >= 0.0 else -0.2 for value in square(time, 2.4)]),
        "steps.csv": ([0.2 if int(t) % 2 == 0 else -0.2 for t in time], [0.25 * value for value in square(time, 3.2)]),
    }[file]
    return {"t_s": time, "goal_rad": goal, "pull_Nm": pull, "begin_rad": [goal[0]] * len(time)}


def hold_inputs(file, time):
    """Pulls to and fro, and none after each, at another goal in each run; a row a second."""
    goal = {"part_0.csv": 0.0, "part_1.csv": 0.2, "part_2.csv": -0.2, "part_3.csv": 0.4}[file]
    return {"t_s": [t / STEP_S for t in time], "goal_rad": [goal] * len(time), "pull_Nm": [0.3 * (1, 0, -1, 0)[i % 4] for i in range(len(time))]}


def arm_inputs(file, time):
    shoulder, elbow = {
        "sweep.csv": ([0.8 * math.sin(2.0 * math.pi * (0.3 * t + 0.2 * t * t)) for t in time],
                      [0.6 * math.sin(2.0 * math.pi * (0.4 * t + 0.3 * t * t) + 1.0) - 0.6 * math.sin(1.0) for t in time]),
        "steps.csv": ([0.9 * value for value in square(time, 2.0)], [0.7 * value for value in square(time, 1.2)]),
        "slow.csv": ([0.6 * math.sin(2.0 * math.pi * 0.4 * t) for t in time], [0.9 * math.sin(2.0 * math.pi * 0.7 * t) for t in time]),
    }[file]
    return {"t_s": time, "shoulder_goal_rad": shoulder, "elbow_goal_rad": elbow}


def inputs_of(model, file):
    """The command of each run over time."""
    time = [STEP_S * i for i in range(FEWER_ROWS.get(model, ROWS))]
    if model == "geared_servo":
        return servo_inputs(file, time)
    if model == "lost_motion":
        return hold_inputs(file, time)
    if model == "mujoco_arm":
        return arm_inputs(file, time)
    share = [t / time[-1] for t in time]
    shapes = {
        "sweep.csv": [math.sin(2.0 * math.pi * (0.4 * t + 0.3 * t * t)) for t in time],
        "steps.csv": [[0.8, -0.5, 1.0, -1.0, 0.3][min(4, int(5.0 * s))] for s in share],
        "slow.csv": [math.sin(2.0 * math.pi * 0.5 * t) for t in time],
        "fast.csv": [math.sin(2.0 * math.pi * 1.0 * t) for t in time],
        "half.csv": [0.5 + 0.5 * math.sin(2.0 * math.pi * 0.7 * t) for t in time],
    }
    column, size = {"series_elastic": ("torque_Nm", 1.0), "geared_pendulum": ("voltage_V", 4.0), "cam_spring": ("angle_rad", 2.8)}[model]
    return {"t_s": time, column: [size * value for value in shapes[file]]}


def before(time, values, delay):
    """values(t - delay), straight between rows."""
    out = []
    for t in time:
        at = (t - delay) / (time[1] - time[0])
        i = max(0, min(len(values) - 2, math.floor(at)))
        out.append(values[0] if at <= 0 else values[i] + (values[i + 1] - values[i]) * (at - i))
    return out


def through_port(kind, size, time, values):
    if kind == "offset":
        return [v + size for v in values]
    if kind == "scale":
        return [v * (1.0 + size) for v in values]
    if kind == "drift":
        return [v + size * t / time[-1] for v, t in zip(values, time)]
    if kind == "dead_zone":
        return [math.copysign(max(0.0, abs(v) - size), v) for v in values]
    return before(time, values, size)


def load_mujoco(program, folder, case):
    """The model by the companion that diagnoses it, and the figures that it states."""
    process = subprocess.Popen([Path(program).resolve().parent / "fusee-mujoco", case["model"]["mjcf"]], cwd=folder, text=True,
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def ask(**question):
        process.stdin.write(json.dumps({"id": 0} | question) + "\n")
        process.stdin.flush()
        answer = json.loads(process.stdout.readline())
        if "error" in answer:
            sys.exit(answer["error"])
        return answer

    described = ask(describe=True)
    for name, figure in described["parameters"].items():
        stated = case["parameters"].get(name, figure)
        described["parameters"][name] = {"nominal": figure["nominal"]} | stated
    (experiment,) = case["experiments"].values()
    simulate = lambda figures, inputs: ask(parameters=figures, inputs=inputs, outputs=list(experiment["outputs"]))["outputs"]
    return simulate, case | {key: described[key] for key in ("parameters", "effects")}


@functools.cache
def load(program, folder):
    case = tomllib.loads((folder / "case.toml").read_text())
    if "mjcf" in case["model"]:
        return load_mujoco(program, folder, case)
    spec = importlib.util.spec_from_file_location(folder.name, folder / "model.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.simulate, case


def measure(program, folder, model, faults, draw):
    """The runs of a rig with these faults: name of the file to columns."""
    simulate, case = load(program, folder)
    figures = {}
    for name, figure in case["parameters"].items():
        sigma = figure.get("tolerance_abs", abs(figure["nominal"]) * figure.get("tolerance", 0.0))
        figures[name] = figure["nominal"] + sigma * max(-2.0, min(2.0, draw.gauss(0.0, 1.0)))
        for cause, size in faults:
            if cause == name:
                figures[name] = figure["nominal"] + sigma * size
    for cause, size in faults:
        if cause in case.get("effects", {}):
            figures[case["effects"][cause]["frees"][0]] += size
    ports = {cause.split(".")[1]: (cause.split(".")[2], size) for cause, size in faults if cause.startswith("port.")}

    def through(name, time, values):
        return through_port(*ports[name], time, values) if name in ports else values

    (experiment,) = case["experiments"].values()
    runs = {}
    for file in experiment["files"]:
        logged = inputs_of(model, file)
        time = logged["t_s"]
        measured = simulate(figures, {name: through(name, time, values) for name, values in logged.items()})
        for name, sigma in experiment["outputs"].items():
            logged[name] = [v + draw.gauss(0.0, sigma) for v in through(name, time, measured[name])]
        runs[file] = logged
    return runs


def write(folder, runs):
    for file, columns in runs.items():
        rows = zip(*columns.values())
        lines = [",".join(columns)] + [",".join(f"{value:.7g}" for value in row) for row in rows]
        (folder / file).write_text("\n".join(lines) + "\n")


def ship(program, models, model):
    write(models / model, measure(program, models / model, model, SHIPPED[model], random.Random(f"{model} ships")))


def label_of(model, draw):
    cause = draw.choice(sorted(FAULTS[model]))
    low, high = FAULTS[model][cause]
    sign = 1 if cause.endswith(ONE_SIDED) else draw.choice((-1, 1))
    return cause, sign * math.exp(draw.uniform(math.log(low), math.log(high)))


def diagnosis_of(program, models, model, faults, draw):
    with tempfile.TemporaryDirectory() as temporary:
        case = Path(temporary) / "case"
        shutil.copytree(models / model, case, ignore=shutil.ignore_patterns("__pycache__", "*.csv"))
        write(case, measure(program, models / model, model, faults, draw))
        run = subprocess.run([program, "diagnose", case, "--out", Path(temporary) / "out", "--json"], capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(run.stderr)
        return json.loads(run.stdout)["result"]["diagnosis"]


def score(program, models, model, seed, count):
    draw = random.Random(f"{model} {seed}")
    labels = [label_of(model, draw) for _ in range(count)]
    named = in_class = others = invented = 0
    for number, fault in enumerate(labels + [None] * count):
        found = diagnosis_of(program, models, model, [fault] if fault else [], draw)
        ids = [effect["id"] for effect in found["effects"]]
        classes = [ids] + [[effect["id"] for effect in other["effects"]] for other in found["alternatives"]]
        sure, open_ = found["verdict"] == "identified", found["verdict"] == "ambiguous"
        if fault:
            named += sure and ids == [fault[0]]
            in_class += open_ and [fault[0]] in classes
            others += sure and ids != [fault[0]]
        else:
            invented += found["verdict"] in ("identified", "partly_explained", "ambiguous", "unknown")
        sizes = [f"{effect['id']} {effect['parameter']['value']:.4g}" for effect in found["effects"]]
        truth = "faultless" if fault is None else f"{fault[0]} {fault[1]:.4g}"
        rest = "; or " + ", ".join(" with ".join(own) or "none" for own in classes[1:]) if open_ else ""
        print(f"{model} {number}: {truth}: {found['verdict']} {', '.join(sizes)}{rest}", file=sys.stderr, flush=True)
    print(json.dumps({"model": model, "seed": seed, "count": count, "named": named, "in_class": in_class, "other": others, "invented": invented}))


if __name__ == "__main__":
    if sys.argv[1] == "--ship":
        ship(sys.argv[2], Path(sys.argv[3]), sys.argv[4])
    else:
        score(sys.argv[1], Path(sys.argv[2]), sys.argv[3], int(sys.argv[4]), int(sys.argv[5]))
