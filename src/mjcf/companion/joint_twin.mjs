// The exact laws of a joint in MuJoCo, written by fusee (docs/guides/mujoco.md). joint_twin.py does the same in Python.
//
//   import load from '@mujoco/mujoco';
//   import { JointTwin } from './joint_twin.mjs';
//   const mujoco = await load();
//   const model = mujoco.MjModel.from_xml_string(readFileSync('joint.xml', 'utf8'));
//   const data = new mujoco.MjData(model);
//   const twin = new JointTwin(mujoco, model, data, JSON.parse(readFileSync('laws.json', 'utf8')));
//   twin.step([1.0, 1.0, 0.0]);        // torques of agonist, antagonist and joint [Nm]
//
// It replaces what MuJoCo has no law for: springs from tables instead of their cubics, and friction that depends on load and speed.

const SIDES = ['agonist', 'antagonist'];
const TURNOVER = 0.05;  // [rad] of deflection within which a spring's hysteresis turns over

/** Torque of a spring over its deflection, without hysteresis [Nm]. */
export function springTorque(spring, x) {
  const rows = spring.torque_Nm, last = rows.length - 1;
  if (x < spring.low_rad) return Math.max(0, rows[0] * (1 + (x - spring.low_rad) / spring.stop_travel_rad));
  if (x >= spring.high_rad) return rows[last] + spring.end_stiffness_Nm_per_rad * (x - spring.high_rad);
  const place = (x - spring.low_rad) / (spring.high_rad - spring.low_rad) * last;
  const i = Math.min(Math.floor(place), last - 1);
  return rows[i] + (place - i) * (rows[i + 1] - rows[i]);
}

/** The same with hysteresis, of a spring that was pulled to x from where `memory` has it. A new memory: { z: -1, last: 0 }. */
export function pullSpring(spring, memory, x) {
  const torque = springTorque(spring, x);
  if (spring.hysteresis === 0) return torque;
  memory.z = Math.min(1, Math.max(-1, memory.z + 2 * (x - memory.last) / TURNOVER));
  memory.last = x;
  return torque * (1 + spring.hysteresis * memory.z);
}

/** Greatest friction of a gear under a load, turning at `speed` or, at rest, driven towards `way` (1: winding in, -1: paying out) [Nm]. */
export function gearFriction(gear, load, speed, way) {
  const rows = gear.load_Nm, size = Math.abs(load);
  let i = 0;
  while (i + 2 < rows.length && size > rows[i + 1]) ++i;
  const share = (size - rows[i]) / (rows[i + 1] - rows[i]);
  const moving = gear.friction_Nm[i] + share * (gear.friction_Nm[i + 1] - gear.friction_Nm[i]);
  const slow = speed / gear.rest_speed_rad_per_s;
  return moving * (1 + way * gear.asymmetry) * (1 + gear.rest_excess * Math.exp(-slow * slow));
}

export class JointTwin {
  /** @param prefix of all names in the model, where the joint was attached to a larger one */
  constructor(mujoco, model, data, laws, prefix = '') {
    Object.assign(this, { mujoco, model, data, laws });
    const id = (kind, name) => {
      const found = mujoco.mj_name2id(model, mujoco.mjtObj[kind].value, prefix + name);
      if (found < 0) throw new Error(`the model has no ${prefix + name}: is it joint.xml of the same folder?`);
      return found;
    };
    const joints = [...SIDES, 'joint'].map((name) => id('mjOBJ_JOINT', name));
    this.places = joints.map((joint) => model.jnt_qposadr[joint]);
    this.dofs = joints.map((joint) => model.jnt_dofadr[joint]);
    this.motors = [...SIDES, 'joint'].map((name) => id('mjOBJ_ACTUATOR', 'torque_' + name));
    for (const name of SIDES)
      for (const spring of ['k_se_', 'k_pe_']) {  // the cubics would act in addition
        const tendon = id('mjOBJ_TENDON', spring + name);
        model.tendon_stiffness[tendon] = 0;
        for (let i = 0; i < 2; ++i) model.tendon_stiffnesspoly[2 * tendon + i] = 0;
      }
    // The stop is a spring with damping, below: MuJoCo's own moves away. (WebAssembly has no jnt_limited.)
    if (laws.joint.stop_rad !== null) [-1e3, 1e3].forEach((end, i) => { model.jnt_range[2 * joints[2] + i] = end; });
    this.reset();
  }

  /** Forgets what the joint remembers; the state of MuJoCo is yours. */
  reset() {
    this.memory = SIDES.map(() => ({ k_se: { z: -1, last: 0 }, k_pe: { z: -1, last: 0 } }));
    this.encoders = [0, 0];
    this.commands = [];
  }

  /** Sets the torques of agonist, antagonist and joint [Nm], the laws, and makes one step. */
  step(torques) {
    this.command(torques);
    this.apply();
    this.mujoco.mj_step(this.model, this.data);
  }

  /** Commands take effect after the delay of the rig, of which most have none. */
  command(torques) {
    const { data, laws } = this;
    this.commands.push({ time: data.time, torques: [...torques] });
    const due = data.time - laws.delay_s + 1e-9;
    while (this.commands.length > 1 && this.commands[1].time <= due) this.commands.shift();
    if (this.commands[0].time > due) return;
    for (let i = 0; i < 3; ++i) data.ctrl[this.motors[i]] = this.commands[0].torques[i];
  }

  /** Springs, friction, gravity and stop at the present state, for the next mj_step. */
  apply() {
    const { model, data, laws } = this;
    const [g1, g2] = SIDES.map((name) => laws[name].ratio), s = SIDES.map((name) => laws[name].capstan_scale);
    this.#followEncoders();
    const place = this.places.map((i) => data.qpos[i]), speed = this.dofs.map((i) => data.qvel[i]);
    const pull = [s[0] * place[0] + g1 * place[2], s[1] * place[1] - g2 * place[2]].map((x, i) => this.#spring(i, 'k_se', x));
    for (let i = 0; i < 2; ++i) {
      const load = s[i] * pull[i] + this.#spring(i, 'k_pe', place[i]);
      data.qfrc_applied[this.dofs[i]] = -load;
      model.dof_frictionloss[this.dofs[i]] = gearFriction(laws[SIDES[i]].gear, load, speed[i], this.#way(i, speed[i], load));
    }
    data.qfrc_applied[this.dofs[2]] = g2 * pull[1] - g1 * pull[0] + this.#outside(place[2], speed[2]);
    model.dof_frictionloss[this.dofs[2]] = laws.joint.friction_Nm + laws.joint.tension_share * (g1 * pull[0] + g2 * pull[1]);
  }

  /** Angles of agonist, antagonist and joint as the encoders of the rig read them, without noise and steps [rad]. */
  read() {
    this.#followEncoders();
    return [...this.encoders, this.data.qpos[this.places[2]] + this.laws.joint.offset_rad];
  }

  /** An encoder behind backlash stays until its capstan takes it along. */
  #followEncoders() {
    for (let i = 0; i < 2; ++i) {
      const theta = this.data.qpos[this.places[i]], half = 0.5 * this.laws[SIDES[i]].gear.backlash_rad;
      this.encoders[i] = Math.min(Math.max(this.encoders[i], theta - half), theta + half);
    }
  }

  #spring(side, name, x) {
    return pullSpring(this.laws[SIDES[side]][name], this.memory[side][name], x);
  }

  /** The way in which a capstan turns or, creeping at rest, is driven. */
  #way(side, speed, load) {
    const gear = this.laws[SIDES[side]].gear, limit = gear.saturation_Nm ?? Infinity;
    const torque = Math.min(limit, Math.max(-limit, gear.torque_scale * this.data.ctrl[this.motors[side]]));
    return Math.sign(Math.abs(speed) > 1e-3 ? speed : torque - load);
  }

  /** Gravity and stop at the joint [Nm]. */
  #outside(q, speed) {
    const joint = this.laws.joint;
    let torque = joint.gravity_Nm === 0 ? 0 : -joint.gravity_Nm * Math.sin(q);
    const inside = joint.stop_rad === null ? 0 : Math.abs(q) - joint.stop_rad;
    if (inside > 0) {
      const damping = 2 * joint.stop_damping * Math.sqrt(joint.stop_stiffness_Nm_per_rad * this.laws.joint_inertia_kgm2);
      torque -= Math.sign(q) * joint.stop_stiffness_Nm_per_rad * inside + damping * speed;
    }
    return torque;
  }
}
