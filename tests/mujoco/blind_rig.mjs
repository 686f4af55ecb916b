// A case of a blind benchmark measured on a rig in MuJoCo.
// node blind_rig.mjs MODEL CASE TO SEED     the inputs of CASE and CASE/heldout, with readings of sensors of [sensors], into TO, TO/heldout
import load from "@mujoco/mujoco";
import { existsSync, mkdirSync, readFileSync } from "node:fs";
import { Bench, measureFolder, numbersOf, randomNumbers } from "./experiments.mjs";
import { JointTwin } from "./joint_twin.mjs";

const [model_folder, case_folder, to, seed] = process.argv.slice(2);
const mujoco = await load();
const xml = readFileSync(`${model_folder}/joint.xml`, "utf8"), laws = JSON.parse(readFileSync(`${model_folder}/laws.json`, "utf8"));
const model = mujoco.MjModel.from_xml_string(xml), data = new mujoco.MjData(model), damping = [...model.dof_damping];
const twin = new JointTwin(mujoco, model, data, laws);
function fresh() {
  mujoco.mj_resetData(model, data);
  damping.forEach((value, i) => { model.dof_damping[i] = value; });
  twin.reset();
  return { model, data, twin };
}
const bench = new Bench(fresh, laws, numbersOf(readFileSync(`${case_folder}/case.toml`, "utf8")), randomNumbers(Number(seed)));
for (const part of ["", "/heldout"].filter((name) => existsSync(case_folder + name))) {
  mkdirSync(to + part, { recursive: true });
  measureFolder(bench, case_folder + part, to + part);
}
