"""Sealed faults of the example simulators: does fusee diagnose name them, and does it name none where there is none?

simulator_faults.py PROGRAM MODELS MODEL SEED COUNT   COUNT faulty and COUNT faultless cases; prints a line a case and the score
simulator_faults.py --ship MODELS                     writes the runs that ship with each example

The truth has its own figures (each within its tolerance), a fault, and noise; the label is looked at after the diagnosis alone.
"""
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
}
SHIPPED = {"series_elastic": ("motor_coulomb", 0.12), "geared_pendulum": ("port.angle_rad.delay", 0.03), "cam_spring": ("lift_m", 10)}


def inputs_of(model, file):
    """The command of each run over time."""
    time = [STEP_S * i for i in range(ROWS)]
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
        at = (t - delay) / STEP_S
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


def load(folder):
    spec = importlib.util.spec_from_file_location(folder.name, folder / "model.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.simulate, tomllib.loads((folder / "case.toml").read_text())


def measure(folder, model, fault, draw):
    """The runs of a rig with this fault: name of the file to columns."""
    simulate, case = load(folder)
    figures = {}
    for name, figure in case["parameters"].items():
        sigma = figure.get("tolerance_abs", abs(figure["nominal"]) * figure.get("tolerance", 0.0))
        figures[name] = figure["nominal"] + sigma * max(-2.0, min(2.0, draw.gauss(0.0, 1.0)))
        if fault and fault[0] == name:
            figures[name] = figure["nominal"] + sigma * fault[1]
    if fault and fault[0] in case.get("effects", {}):
        figures[case["effects"][fault[0]]["frees"][0]] += fault[1]
    port = fault[0].split(".") if fault and fault[0].startswith("port.") else ["", "", ""]
    (experiment,) = case["experiments"].values()
    runs = {}
    for file in experiment["files"]:
        logged = inputs_of(model, file)
        time = logged["t_s"]
        at_work = {n: through_port(port[2], fault[1], time, v) if n == port[1] else v for n, v in logged.items()}
        measured = simulate(figures, at_work)
        for name, sigma in experiment["outputs"].items():
            values = through_port(port[2], fault[1], time, measured[name]) if name == port[1] else measured[name]
            logged[name] = [v + draw.gauss(0.0, sigma) for v in values]
        runs[file] = logged
    return runs


def write(folder, runs):
    for file, columns in runs.items():
        rows = zip(*columns.values())
        lines = [",".join(columns)] + [",".join(f"{value:.7g}" for value in row) for row in rows]
        (folder / file).write_text("\n".join(lines) + "\n")


def ship(models):
    for model, (cause, size) in SHIPPED.items():
        write(models / model, measure(models / model, model, (cause, size), random.Random(f"{model} ships")))


def score(program, models, model, seed, count):
    draw = random.Random(f"{model} {seed}")
    labels = []
    for i in range(count):
        cause = draw.choice(sorted(FAULTS[model]))
        low, high = FAULTS[model][cause]
        sign = draw.choice((-1, 1)) if cause not in ("motor_coulomb", "play", "coulomb", "load_friction", "slide_friction", "bearing_friction", "hardening") and \
            not cause.endswith((".delay", ".dead_zone")) else 1
        labels.append((cause, sign * math.exp(draw.uniform(math.log(low), math.log(high)))))
    named = others = invented = 0
    for number, fault in enumerate(labels + [None] * count):
        with tempfile.TemporaryDirectory() as temporary:
            case = Path(temporary) / "case"
            shutil.copytree(models / model, case, ignore=shutil.ignore_patterns("__pycache__", "*.csv"))
            write(case, measure(models / model, model, fault, draw))
            run = subprocess.run([program, "diagnose", case, "--out", Path(temporary) / "out", "--json"], capture_output=True, text=True)
            if run.returncode != 0:
                sys.exit(run.stderr)
            found = json.loads(run.stdout)["result"]["diagnosis"]
        ids = [effect["id"] for effect in found["effects"]]
        right = found["verdict"] == "identified" and fault is not None and ids == [fault[0]]
        named += right
        others += found["verdict"] == "identified" and fault is not None and not right
        invented += fault is None and found["verdict"] in ("identified", "partly_explained", "ambiguous", "unknown")
        sizes = [f"{effect['id']} {effect['parameter']['value']:.4g}" for effect in found["effects"]]
        print(f"{model} {number}: {'faultless' if fault is None else f'{fault[0]} {fault[1]:.4g}'}: {found['verdict']} {', '.join(sizes)}", flush=True)
    print(f"{model}: named {named} of {count}, another name {others}; of {count} faultless {invented} with a gap")


if __name__ == "__main__":
    if sys.argv[1] == "--ship":
        ship(Path(sys.argv[2]))
    else:
        score(sys.argv[1], Path(sys.argv[2]), sys.argv[3], int(sys.argv[4]), int(sys.argv[5]))
