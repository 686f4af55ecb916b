#!/usr/bin/env python3
"""The two companion programs of a model for MuJoCo, in Python and JavaScript, do the same in each state. MuJoCo itself is replaced by a
record of its fields: what is compared is what the companions write into it.

companions_test.py PROGRAM SOURCE     77: skipped, node is not installed
"""
import importlib.util, json, math, pathlib, random, shutil, subprocess, sys, tempfile

HERE = pathlib.Path(__file__).resolve().parent
JOINTS = ("agonist", "antagonist", "joint")
STATES = 2000


class Fields(dict):
    __getattr__ = dict.__getitem__
    __setattr__ = dict.__setitem__


def stub():
    """mj_name2id, and the fields of a model of three hinges and four tendons."""
    ids = {name: i for i, name in enumerate(JOINTS)} | {"torque_" + name: i for i, name in enumerate(JOINTS)}
    ids |= {f"k_{spring}_{side}": 2 * i + k for i, side in enumerate(JOINTS[:2]) for k, spring in enumerate(("se", "pe"))}
    kinds = Fields(mjOBJ_JOINT=0, mjOBJ_ACTUATOR=0, mjOBJ_TENDON=0)
    engine = Fields(mjtObj=kinds, mj_name2id=lambda model, kind, name: ids.get(name, -1))
    model = Fields(jnt_qposadr=[0, 1, 2], jnt_dofadr=[0, 1, 2], tendon_stiffness=[1.0] * 4, tendon_stiffnesspoly=[[1.0, 1.0]] * 4, jnt_range=[(0, 0)] * 3,
                   dof_frictionloss=[0.0] * 3)
    return engine, model, Fields(qpos=[0.0] * 3, qvel=[0.0] * 3, ctrl=[0.0] * 3, qfrc_applied=[0.0] * 3, time=0.0)


def laws_of(file):
    """Those of the shipped joint, with every effect that the companions have."""
    laws = json.loads(file.read_text())
    laws |= {"delay_s": 0.004}
    laws["agonist"] |= {"ratio": 1.3, "capstan_scale": 1.07}
    laws["joint"] |= {"friction_Nm": 0.05, "tension_share": 0.03, "gravity_Nm": 0.2, "stop_rad": 0.9, "stop_stiffness_Nm_per_rad": 40.0, "stop_damping": 0.4, "offset_rad": 0.02}
    laws["agonist"]["gear"] |= {"asymmetry": 0.2, "rest_excess": 0.3, "torque_scale": 0.9, "saturation_Nm": 1.2, "backlash_rad": 0.03}
    laws["antagonist"]["gear"] |= {"asymmetry": -0.1, "rest_excess": 0.1, "saturation_Nm": None, "backlash_rad": 0.0}
    for side, spring, share in (("agonist", "k_se", 0.15), ("antagonist", "k_pe", 0.08)):
        laws[side][spring]["hysteresis"] = share
    return laws


def states_of(draw):
    """A walk, with leaps: springs turn over, encoders meet the ends of their backlash, the joint its stop."""
    qpos, states = [0.0] * 3, []
    for i in range(STATES):
        qpos = [x + draw.gauss(0.0, 0.02) for x in qpos] if draw.random() < 0.95 else [draw.uniform(-0.5, 3.0), draw.uniform(-0.5, 3.0), draw.uniform(-1.2, 1.2)]
        qvel = [draw.choice((0.0, 5e-4, 0.3, 3.0)) * draw.uniform(-1.0, 1.0) for _ in JOINTS]
        states.append({"time": 0.001 * i, "qpos": qpos, "qvel": qvel, "torques": [draw.uniform(-0.5, 2.0) for _ in JOINTS]})
    return states


def in_python(folder, laws, states):
    spec = importlib.util.spec_from_file_location("joint_twin", folder / "joint_twin.py")
    companion = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(companion)
    engine, model, data = stub()
    twin = companion.JointTwin(engine, model, data, laws)
    rows = []
    for state in states:
        data.update(time=state["time"], qpos=state["qpos"], qvel=state["qvel"])
        twin.command(state["torques"])
        twin.apply()
        rows.append([*data.ctrl, *data.qfrc_applied, *model.dof_frictionloss, *twin.read()])
    return rows


def main():
    if not shutil.which("node"):
        print("skipped: node is not installed: the companion in JavaScript was not run")
        return 77
    program, source = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
    with tempfile.TemporaryDirectory() as work:
        work = pathlib.Path(work)
        subprocess.run([program, "simulate", source / "profiles/pnrvsa.toml", "--levels", "2", "--out", "out", "--write-mjcf", "mjcf", "-q"], cwd=work, check=True)
        folder = work / "mjcf/pnrvsa"
        laws, states = laws_of(folder / "laws.json"), states_of(random.Random(1))
        (work / "given.json").write_text(json.dumps({"laws": laws, "states": states}))
        node = subprocess.run(["node", HERE / "companions.mjs", folder / "joint_twin.mjs", work / "given.json"], check=True, capture_output=True, text=True)
        ours, theirs = in_python(folder, laws, states), json.loads(node.stdout)
    assert len(ours) == len(theirs) == STATES
    columns = list(zip(*ours))
    assert all(len(set(column)) > 10 for column in columns), "a column that hardly changes compares nothing"
    worst = max(abs(a - b) / max(1.0, abs(a)) for mine, other in zip(ours, theirs) for a, b in zip(mine, other))
    print(f"{STATES} states, {len(columns)} values each: at most {worst:.2g} apart")
    return 0 if worst < 1e-12 and not math.isnan(worst) else 1


sys.exit(main())
