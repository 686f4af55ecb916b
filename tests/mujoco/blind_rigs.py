#!/usr/bin/env python3
"""Cases of a blind benchmark whose rigs move in MuJoCo: a third plant beside those of docs/theory/plant.md.

blind_rigs.py PROGRAM BENCHMARK OUT MODULES [COUNT]

BENCHMARK: a folder of `fusee blind make`. Each case whose effects the library holds gets a rig with these effects and its own build errors
(normal, with the case's tolerances) as the model for MuJoCo of `fusee predict --write-mjcf`; the inputs are those of the case, the readings
are MuJoCo's. OUT has the same form, with labels sealed again: `fusee blind score OUT --out SCORE` judges it. MODULES: the folder with
node_modules that mujoco_test.sh makes.
"""
import base64, hashlib, json, pathlib, random, shutil, subprocess, sys

HERE = pathlib.Path(__file__).resolve().parent


def number_of(toml, name):
    line = next(line for line in toml.splitlines() if line.startswith(name + " ="))
    return float(line.split("=")[1])


def tolerances(toml):
    """One sigma of each build parameter, by the name in diagnosis.json."""
    rig = toml[: toml.index("[tolerance]")]
    table = toml[toml.index("[tolerance]"):]
    of = lambda name: number_of(table, name)
    friction = of("gear_load_friction") * number_of(rig, "gear_load_friction")
    sided = {"gear load friction": friction, "K_SE rate": of("spring_rate"), "K_PE rate": of("spring_rate"), "K_SE radius": of("se_radius_m"),
             "K_PE radius": of("pe_radius_m"), "K_SE preload": of("se_preload_rad"), "K_PE preload": of("pe_preload_m"), "torque scale": of("torque_scale"),
             "joint radius": of("radii"), "capstan radius": of("radii"), "motor inertia": of("inertia")}
    sigmas = {f"{name} {side}": sigma for side in ("agonist", "antagonist") for name, sigma in sided.items()}
    return sigmas | {"joint inertia": of("inertia"), "joint bearing friction": of("joint_coulomb_Nm"), "joint encoder zero": of("joint_offset_rad")}


def truth_of(label, toml, seed):
    """The label as diagnosis.json: its effects, and build errors at random."""
    draw = random.Random(seed)
    value = lambda x: {"value": x, "ci95": [x, x]}
    effects = [{"id": e["id"], "side": e["side"], "probability": 1.0, "parameter": value(e["size"])} for e in label["effects"]]
    build = {name: value(draw.gauss(0.0, sigma)) for name, sigma in tolerances(toml).items()}
    return {"verdict": "identified" if effects else "none", "effects": effects, "build": build}


def measure(program, source, to, label, modules, seed):
    toml = (source / "case.toml").read_text()
    to.mkdir(parents=True)
    for name in ("case.toml", "nominal_springs.csv"):
        shutil.copy(source / name, to)
    work = to.parent / ("." + to.name)
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir()
    (work / "truth.json").write_text(json.dumps(truth_of(label, toml, seed)))
    subprocess.run([program, "predict", source, "--effects", work / "truth.json", "--out", work / "expected", "--write-mjcf", work / "mjcf", "-q"],
                   check=True, stdout=subprocess.DEVNULL)
    shutil.copy(work / "mjcf/joint_twin.mjs", modules)
    subprocess.run(["node", modules / "blind_rig.mjs", work / "mjcf", source, to, str(seed)], check=True)
    shutil.rmtree(work)


def main():
    program, bench, out, modules = (pathlib.Path(a).resolve() for a in sys.argv[1:5])
    sealed = json.loads(base64.b64decode((bench / "labels.sealed").read_text()))
    labels = [label for label in sealed["labels"] if label["in_library"]][: int(sys.argv[5]) if len(sys.argv) > 5 else None]
    for name in ("experiments.mjs", "blind_rig.mjs"):
        shutil.copy(HERE / name, modules)
    out.mkdir(exist_ok=True)
    for i, label in enumerate(labels):
        if (out / label["case"]).exists():
            continue
        part = out / ("part_" + label["case"])
        shutil.rmtree(part, ignore_errors=True)
        measure(program, bench / label["case"], part, label, modules, sealed["seed"] * 100003 + i)
        part.rename(out / label["case"])  # whole cases only: a run that was stopped goes on here
        print(f"{i + 1}/{len(labels)} {label['case']}", flush=True)
    text = base64.b64encode(json.dumps(sealed | {"labels": labels}, sort_keys=True, separators=(",", ":")).encode())
    (out / "labels.sealed").write_bytes(text)
    (out / "seal.txt").write_text("sha256:" + hashlib.sha256(text).hexdigest() + "\n")


main()
