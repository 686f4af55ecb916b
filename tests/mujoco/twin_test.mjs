// The model and the companion program of `fusee simulate --write-mjcf`, in the official engine, against fusee's own figures.
// node twin_test.mjs FOLDER_OF_THE_MODEL FOLDER_OF_THE_SIMULATION [all]     all: every co-contraction, else the least and the greatest
import load from "@mujoco/mujoco";
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [model_folder, simulation_folder, scope] = process.argv.slice(2);
const text = (folder, name) => readFileSync(`${folder}/${name}`, "utf8");
const { JointTwin } = await import(pathToFileURL(`${model_folder}/joint_twin.mjs`));
const mujoco = await load();
const xml = text(model_folder, "joint.xml"), laws = JSON.parse(text(model_folder, "laws.json"));
const kTorqueError = 1e-3, kWidthError = 0.03, kHand_Nms = 0.1;  // the hand that pushes damps the joint
const kRamp_s = 6, kHold_s = 2, kRelease_s = 20, kRest_s = 1;    // faster releases creep
let failures = 0;

function expect(holds, what) {
  console.log(`${holds ? "ok  " : "FAIL"} ${what}`);
  if (!holds) ++failures;
}
function fresh() {
  const model = mujoco.MjModel.from_xml_string(xml), data = new mujoco.MjData(model);
  return { model, data, twin: new JointTwin(mujoco, model, data, laws) };
}

/** Torque of both springs of a side over the capstan's angle as the engine has it, against springs.csv of fusee. */
function checkSprings() {
  const [header, ...rows] = text(simulation_folder, "springs.csv").trim().split("\n").map((line) => line.split(","));
  const column = (name) => header.indexOf(name), numbers = rows.map((row) => row.map(Number));
  const [angle, se, pe] = ["theta_rad", "f_se_Nm", "f_pe_Nm"].map(column);
  const { data, twin } = fresh();
  const greatest = Math.max(...numbers.map((row) => row[se] + row[pe]));
  let worst = 0;
  for (const row of numbers) {
    data.qpos[twin.places[0]] = row[angle];  // q = 0: the series spring is stretched by the same angle
    twin.apply();
    worst = Math.max(worst, Math.abs(-data.qfrc_applied[twin.dofs[0]] - row[se] - row[pe]) / greatest);
  }
  expect(numbers.length > 50 && worst < kTorqueError, `torque over ${numbers.length} deflections: at most ${(100 * worst).toPrecision(2)} % of the greatest apart`);
}

/** Width of a push-and-release test at one co-contraction [rad]. */
function width({ tau_Nm, push_torque_Nm }) {
  const { model, data, twin } = fresh();
  model.dof_damping[twin.dofs[2]] = kHand_Nms;
  let now = [0, 0, 0];
  const lead = (to, seconds) => {
    const from = now, steps = Math.ceil(seconds / model.opt.timestep);
    for (let i = 1; i <= steps; ++i) {
      const share = (i / steps) ** 2 * (3 - (2 * i) / steps);
      twin.step(from.map((torque, k) => torque + share * (to[k] - torque)));
    }
    now = to;
  };
  const rest = [tau_Nm, tau_Nm, 0];
  lead(rest, kRamp_s);
  lead(rest, kHold_s);
  const [high, low] = [push_torque_Nm, -push_torque_Nm].map((push) => {
    lead([tau_Nm, tau_Nm, push], kRamp_s);
    lead(now, kHold_s);
    lead(rest, kRelease_s);
    lead(rest, kRest_s);
    return data.qpos[twin.places[2]];
  });
  return high - low;
}

/** A joint with a stop and slack cables rests where the stop bears its torque. */
function checkStop() {
  const stop_rad = 0.2, stiffness = 60, torque = 6;
  const own = structuredClone(laws);
  Object.assign(own.joint, { stop_rad, stop_stiffness_Nm_per_rad: stiffness, stop_damping: 0.5 });
  const ranged = xml.replace('<joint name="joint" ', `<joint name="joint" range="-${stop_rad} ${stop_rad}" `);
  const model = mujoco.MjModel.from_xml_string(ranged), data = new mujoco.MjData(model), twin = new JointTwin(mujoco, model, data, own);
  model.dof_damping[twin.dofs[2]] = kHand_Nms;
  const steps = Math.ceil(10 / model.opt.timestep);
  for (let i = 1; i <= steps; ++i) twin.step([0, 0, torque * Math.min(1, (2 * i) / steps)]);
  const q = data.qpos[twin.places[2]], wanted = stop_rad + torque / stiffness;
  expect(Math.abs(q - wanted) < 2e-3, `joint with a stop rests at ${q.toFixed(4)} rad, balance at ${wanted.toFixed(4)} rad`);
}

checkSprings();
checkStop();
const { levels } = JSON.parse(text(simulation_folder, "simulation.json"));
const tested = scope === "all" ? levels : [levels[0], levels.at(-1)];
for (const level of tested) {
  const ratio = width(level) / level.measured_rad;
  expect(Math.abs(ratio - 1) < kWidthError, `dead-band at ${level.tau_Nm} Nm: ${ratio.toFixed(4)} times fusee's`);
}
console.log(`${tested.length} co-contractions, ${failures} failures`);
process.exit(failures || tested.length === 0 ? 1 : 0);
