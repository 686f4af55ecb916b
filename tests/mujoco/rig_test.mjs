// A rig with the effects of a diagnosis in MuJoCo, against what fusee predicts for it.
// node rig_test.mjs MODEL CASE PREDICTED     readings without noise of each experiment of CASE, against the same files in PREDICTED
import load from "@mujoco/mujoco";
import { measureFolder, openBench, readTable } from "./experiments.mjs";

const [model_folder, case_folder, predicted] = process.argv.slice(2);
const measured = {
  breakaway: ["load_torque_Nm"], spring_pull: ["torque_Nm"], dead_band: ["q_high_rad", "q_low_rad"], joint_stiffness: ["q_rad"],
  cocontraction: ["theta_agonist_rad", "theta_antagonist_rad", "q_rad"], log: ["theta_agonist_rad", "theta_antagonist_rad", "q_rad"],
};
const bench = openBench(await load(), model_folder, case_folder, null);
const done = measureFolder(bench, case_folder, null);
const kApart = 0.005;  // root mean square, of the greatest reading of the experiment: the creep of MuJoCo's friction
let failures = 0;
for (const [experiment, rows] of Object.entries(done)) {
  const wanted = readTable(`${predicted}/${experiment}.csv`).rows, names = measured[experiment];
  const greatest = Math.max(...wanted.flatMap((row) => names.map((name) => Math.abs(row[name]))));
  const squares = rows.flatMap((row, i) => names.map((name) => (row[name] - wanted[i][name]) ** 2));
  const share = Math.sqrt(squares.reduce((sum, x) => sum + x, 0) / squares.length) / greatest, holds = greatest > 0 && share < kApart;
  if (!holds) ++failures;
  console.log(`${holds ? "ok  " : "FAIL"} ${experiment}: ${rows.length} rows, ${(100 * share).toPrecision(2)} % of the greatest reading apart`);
}
console.log(`${Object.keys(done).length} experiments of a rig with effects, ${failures} failures`);
process.exit(failures || Object.keys(done).length !== 6 ? 1 : 0);
