// The six experiments of a gap case (docs/gap.md) on a rig in MuJoCo: reads the inputs of a case, fills in what its sensors would read.
import { readFileSync, writeFileSync, existsSync } from "node:fs";
import { JointTwin, gearFriction, pullSpring, springTorque } from "./joint_twin.mjs";

const SIDES = ["agonist", "antagonist"];
const HAND = { damping: 0.36, push_share: 0.72, settle_share: 0.11 };  // as in fusee/joint_model/built_rig.h
const smooth = (s) => { const t = Math.min(1, Math.max(0, s)); return t * t * (3 - 2 * t); };

/** Uniform numbers of a seed (mulberry32), and normal ones. */
export function randomNumbers(seed) {
  let state = seed >>> 0;
  const uniform = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
  return { uniform, normal: () => Math.sqrt(-2 * Math.log(1 - uniform())) * Math.cos(2 * Math.PI * uniform()) };
}

/** Numbers of the tables [sensors] and [protocol] of a case.toml, by name. */
function numbersOf(toml) {
  return Object.fromEntries([...toml.matchAll(/^(\w+) *= *([-+.\deE]+) *(?:#.*)?$/gm)].map(([, name, value]) => [name, Number(value)]));
}

export function readTable(file) {
  const [head, ...lines] = readFileSync(file, "utf8").trim().split("\n").map((line) => line.split(","));
  const rows = lines.map((cells) => Object.fromEntries(head.map((name, i) => [name, Number.isNaN(Number(cells[i])) ? cells[i] : Number(cells[i])])));
  return { head, rows };
}

/** `fresh()` makes a rig at rest: { model, data, twin }. `figures`: numbersOf(case.toml). `random`: null for readings without noise. */
class Bench {
  constructor(fresh, laws, figures, random) {
    Object.assign(this, { fresh, laws, figures, random });
  }
  #noise() { return this.random ? this.random.normal() : 0; }
  #encoder(angle) {
    if (!this.random) return angle;
    const step = this.figures.encoder_step_rad;
    return step * Math.round((angle + this.figures.encoder_noise_rad * this.#noise()) / step);
  }
  #torque(value) { return value * (1 + this.figures.torque_noise_relative * this.#noise()) + this.figures.torque_noise_Nm * this.#noise(); }

  /** For `seconds`, the torques at a share of them. */
  #run(rig, seconds, torques) {
    const steps = Math.max(1, Math.round(seconds / rig.model.opt.timestep));
    for (let i = 1; i <= steps; ++i) rig.twin.step(torques(i / steps));
    return rig;
  }
  #coContracted([agonist, antagonist], hand = 0) {
    const rig = this.fresh(), { motor_ramp_s: ramp, motor_settle_s: settle } = this.figures;
    rig.model.dof_damping[rig.twin.dofs[2]] += hand;
    return this.#run(rig, ramp + settle, (s) => { const share = Math.min(1, (s * (ramp + settle)) / ramp); return [share * agonist, share * antagonist, 0]; });
  }

  /** The load L at which the capstan starts: |L - torque| is the friction at rest under L. */
  breakaway(rows) {
    for (const row of rows) {
      const gear = this.laws[row.side].gear, back = row.direction === "backdrive", scatter = 1 + (this.figures.breakaway_scatter ?? 0) * this.#noise();
      const torque = Math.min(gear.saturation_Nm ?? Infinity, gear.torque_scale * row.motor_torque_Nm);
      const excess = (load) => (back ? load - torque : torque - load) - scatter * gearFriction(gear, load, 0, back ? -1 : 1);
      let [low, high] = back ? [torque, 20 * torque + 20] : [0, torque];  // excess is negative at the torque itself
      for (let i = 0; i < 80; ++i) { const middle = 0.5 * (low + high); if ((excess(middle) < 0) === back) low = middle; else high = middle; }
      row.load_torque_Nm = Math.max(0, this.#torque(0.5 * (low + high)));
    }
  }

  spring_pull(rows) {
    for (const spring of ["se", "pe"])
      for (const side of SIDES) {
        const law = this.laws[side]["k_" + spring], memory = { z: -1, last: 0 };
        let last = 0;
        for (const row of rows.filter((r) => r.spring === spring && r.side === side)) {
          let torque = 0;
          for (let part = 1; part <= 20; ++part) torque = pullSpring(law, memory, last + ((row.deflection_rad - last) * part) / 20);
          last = row.deflection_rad;
          row.torque_Nm = this.#torque(torque);
        }
      }
  }

  /** Damping at the joint by the hand that pushes it [Nms/rad]. Without noise: as fusee expects it, a share of critical damping. */
  #hand(c, top, grip) {
    if (this.random) return grip * (0.035 + (0.1 * c) / top);
    const { data, twin } = this.#coContracted([c, c]), reach = 0.02;
    const stiffness = SIDES.map((side, i) => {
      const at = this.laws[side].capstan_scale * data.qpos[twin.places[i]], law = this.laws[side].k_se;
      return (this.laws[side].ratio ** 2 * (springTorque(law, at + reach) - springTorque(law, at - reach))) / (2 * reach);
    });
    return 2 * HAND.damping * Math.sqrt((stiffness[0] + stiffness[1]) * this.laws.joint_inertia_kgm2);
  }

  /** Push, hold, release, read q; then the same to the other side. */
  dead_band(rows) {
    const { dead_band_push_s: push_s, dead_band_release_s: release_s } = this.figures;
    const push_share = this.random ? 0.75 : HAND.push_share, release_share = this.random ? 0.8 : 1 - HAND.settle_share;
    const top = Math.max(...rows.map((row) => row.cocontraction_Nm)), grip = this.random ? 0.7 + 0.6 * this.random.uniform() : 1;
    for (const row of rows) {
      const c = row.cocontraction_Nm, rig = this.#coContracted([c, c], this.#hand(c, top, grip));
      const released = (push) => {
        this.#run(rig, push_s, (s) => [c, c, push * smooth(s / push_share)]);
        this.#run(rig, release_s, (s) => [c, c, push * (1 - smooth(s / release_share))]);
        return this.#encoder(rig.twin.read()[2]);
      };
      row.q_high_rad = released(row.push_torque_Nm);
      row.q_low_rad = released(-row.push_torque_Nm);
    }
  }

  joint_stiffness(rows) {
    let rig = null, last = null, torque = 0;
    rows.forEach((row, i) => {
      const c = row.cocontraction_Nm, phase = rows.filter((r) => r.cocontraction_Nm === c && r.phase === row.phase);
      if (!last || last.cocontraction_Nm !== c) { rig = this.#coContracted([c, c]); torque = 0; }
      // The command is the straight line of the phase; the case's column is what its sensor read.
      const place = i - rows.indexOf(phase[0]), ends = row.phase.startsWith("load") ? [0, 1] : [1, 0], sign = row.phase.endsWith("+") ? 1 : -1;
      const highest = Math.max(...rows.filter((r) => r.cocontraction_Nm === c).map((r) => Math.abs(r.joint_torque_Nm)));
      const line = sign * highest * (ends[0] + ((ends[1] - ends[0]) * place) / phase.length), from = torque;
      const command = this.random ? line : row.joint_torque_Nm;
      this.#run(rig, this.figures.joint_stiffness_phase_s / phase.length, (s) => [c, c, from + s * (command - from)]);
      torque = command;
      if (this.random) row.joint_torque_Nm = this.#torque(command);
      row.q_rad = this.#encoder(rig.twin.read()[2]);
      last = row;
    });
  }

  cocontraction(rows) {
    const rig = this.fresh(), seconds_per_Nm = this.figures.cocontraction_phase_s / Math.max(...rows.map((row) => row.motor_torque_Nm));
    let torque = 0;
    for (const row of rows) {
      const from = torque, to = row.motor_torque_Nm;
      if (to !== from) this.#run(rig, seconds_per_Nm * Math.abs(to - from), (s) => { const now = from + s * (to - from); return [now, now, 0]; });
      torque = to;
      [row.theta_agonist_rad, row.theta_antagonist_rad, row.q_rad] = rig.twin.read().map((angle) => this.#encoder(angle));
    }
  }

  log(rows) {
    const torques = (row) => [row.motor_torque_agonist_Nm, row.motor_torque_antagonist_Nm, row.joint_torque_Nm];
    const rig = this.#coContracted(torques(rows[0]));
    rows.forEach((row, i) => {
      if (i > 0) {
        const from = torques(rows[i - 1]), to = torques(row);
        this.#run(rig, row.t_s - rows[i - 1].t_s, (s) => from.map((torque, k) => torque + s * (to[k] - torque)));
      }
      [row.theta_agonist_rad, row.theta_antagonist_rad, row.q_rad] = rig.twin.read().map((angle) => this.#encoder(angle));
    });
  }
}

/** The bench of a model that fusee wrote, with the sensors and the protocol of a case. */
export function openBench(mujoco, model_folder, case_folder, random) {
  const text = (file) => readFileSync(file, "utf8"), laws = JSON.parse(text(`${model_folder}/laws.json`));
  const model = mujoco.MjModel.from_xml_string(text(`${model_folder}/joint.xml`)), data = new mujoco.MjData(model), damping = [...model.dof_damping];
  const twin = new JointTwin(mujoco, model, data, laws);
  const fresh = () => {
    mujoco.mj_resetData(model, data);
    damping.forEach((value, i) => { model.dof_damping[i] = value; });
    twin.reset();
    return { model, data, twin };
  };
  return new Bench(fresh, laws, numbersOf(text(`${case_folder}/case.toml`)), random);
}

export const EXPERIMENTS = ["breakaway", "spring_pull", "dead_band", "joint_stiffness", "cocontraction", "log"];

/** Runs the experiments that the folder `from` has, and writes the same files into `to`. @return rows by experiment */
export function measureFolder(bench, from, to, experiments = EXPERIMENTS) {
  const done = {};
  for (const experiment of experiments.filter((name) => existsSync(`${from}/${name}.csv`))) {
    const { head, rows } = readTable(`${from}/${experiment}.csv`);
    bench[experiment](rows);
    const text = (value) => (typeof value === "number" ? String(Number(value.toPrecision(9))) : value);
    if (to) writeFileSync(`${to}/${experiment}.csv`, [head.join(","), ...rows.map((row) => head.map((name) => text(row[name])).join(","))].join("\n") + "\n");
    done[experiment] = rows;
  }
  return done;
}
