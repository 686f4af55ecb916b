// A case of a blind benchmark measured on a rig in MuJoCo.
// node blind_rig.mjs MODEL CASE TO SEED     the inputs of CASE and CASE/heldout, with readings of sensors of [sensors], into TO, TO/heldout
import load from "@mujoco/mujoco";
import { existsSync, mkdirSync } from "node:fs";
import { measureFolder, openBench, randomNumbers } from "./experiments.mjs";

const [model_folder, case_folder, to, seed] = process.argv.slice(2);
const bench = openBench(await load(), model_folder, case_folder, randomNumbers(Number(seed)));
for (const part of ["", "/heldout"].filter((name) => existsSync(case_folder + name))) {
  mkdirSync(to + part, { recursive: true });
  measureFolder(bench, case_folder + part, to + part);
}
