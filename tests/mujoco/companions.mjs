// What joint_twin.mjs writes into MuJoCo's fields in given states: companions_test.py.     node companions.mjs JOINT_TWIN GIVEN
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [companion, given] = process.argv.slice(2);
const { JointTwin } = await import(pathToFileURL(companion));
const { laws, states } = JSON.parse(readFileSync(given, "utf8"));
const ids = { agonist: 0, antagonist: 1, joint: 2, torque_agonist: 0, torque_antagonist: 1, torque_joint: 2, k_se_agonist: 0, k_pe_agonist: 1, k_se_antagonist: 2, k_pe_antagonist: 3 };
const kind = { value: 0 };
const engine = { mjtObj: { mjOBJ_JOINT: kind, mjOBJ_ACTUATOR: kind, mjOBJ_TENDON: kind }, mj_name2id: (model, of, name) => ids[name] ?? -1 };
const zeros = (n) => new Float64Array(n);
const model = { jnt_qposadr: [0, 1, 2], jnt_dofadr: [0, 1, 2], tendon_stiffness: zeros(4), tendon_stiffnesspoly: zeros(8), jnt_range: zeros(6), dof_frictionloss: zeros(3) };
const data = { qpos: zeros(3), qvel: zeros(3), ctrl: zeros(3), qfrc_applied: zeros(3), time: 0 };
const twin = new JointTwin(engine, model, data, laws);
const rows = states.map(({ time, qpos, qvel, torques }) => {
  Object.assign(data, { time, qpos, qvel });
  twin.command(torques);
  twin.apply();
  return [...data.ctrl, ...data.qfrc_applied, ...model.dof_frictionloss, ...twin.read()];
});
console.log(JSON.stringify(rows));
