"""The exact laws of a joint in MuJoCo, written by fusee (docs/guides/mujoco.md). joint_twin.mjs does the same in JavaScript.

    import json, mujoco
    from joint_twin import JointTwin
    model = mujoco.MjModel.from_xml_path("joint.xml")
    data = mujoco.MjData(model)
    twin = JointTwin(mujoco, model, data, json.load(open("laws.json")))
    twin.step([1.0, 1.0, 0.0])        # torques of agonist, antagonist and joint [Nm]

It replaces what MuJoCo has no law for: springs from tables instead of their cubics, and friction that depends on load and speed.
"""
import math

SIDES = ("agonist", "antagonist")
TURNOVER = 0.05  # [rad] of deflection within which a spring's hysteresis turns over


def spring_torque(spring, x):
    """Torque of a spring over its deflection, without hysteresis [Nm]."""
    rows = spring["torque_Nm"]
    last = len(rows) - 1
    low, high = spring["low_rad"], spring["high_rad"]
    if x < low:
        return max(0.0, rows[0] * (1.0 + (x - low) / spring["stop_travel_rad"]))
    if x >= high:
        return rows[last] + spring["end_stiffness_Nm_per_rad"] * (x - high)
    place = (x - low) / (high - low) * last
    i = min(int(place), last - 1)
    return rows[i] + (place - i) * (rows[i + 1] - rows[i])


def pull_spring(spring, memory, x):
    """The same with hysteresis, of a spring that was pulled to x from where memory has it. A new memory: [-1.0, 0.0]."""
    torque = spring_torque(spring, x)
    if spring["hysteresis"] == 0.0:
        return torque
    memory[0] = min(1.0, max(-1.0, memory[0] + 2.0 * (x - memory[1]) / TURNOVER))
    memory[1] = x
    return torque * (1.0 + spring["hysteresis"] * memory[0])


def gear_friction(gear, load, speed, way):
    """Greatest friction under a load, turning at speed or, at rest, driven towards way (1: winding in, -1: paying out) [Nm]."""
    rows, friction, size = gear["load_Nm"], gear["friction_Nm"], abs(load)
    i = 0
    while i + 2 < len(rows) and size > rows[i + 1]:
        i += 1
    share = (size - rows[i]) / (rows[i + 1] - rows[i])
    moving = friction[i] + share * (friction[i + 1] - friction[i])
    slow = speed / gear["rest_speed_rad_per_s"]
    return moving * (1.0 + way * gear["asymmetry"]) * (1.0 + gear["rest_excess"] * math.exp(-slow * slow))


def _sign(value):
    return (value > 0.0) - (value < 0.0)


class JointTwin:
    """prefix: of all names in the model, where the joint was attached to a larger one."""

    def __init__(self, mujoco, model, data, laws, prefix=""):
        self.mujoco, self.model, self.data, self.laws = mujoco, model, data, laws

        def find(kind, name):
            found = mujoco.mj_name2id(model, getattr(mujoco.mjtObj, kind), prefix + name)
            if found < 0:
                raise ValueError(f"the model has no {prefix + name}: is it joint.xml of the same folder?")
            return found

        names = (*SIDES, "joint")
        joints = [find("mjOBJ_JOINT", name) for name in names]
        self.places = [int(model.jnt_qposadr[joint]) for joint in joints]
        self.dofs = [int(model.jnt_dofadr[joint]) for joint in joints]
        self.motors = [find("mjOBJ_ACTUATOR", "torque_" + name) for name in names]
        for name in SIDES:
            for spring in ("k_se_", "k_pe_"):  # the cubics would act in addition
                tendon = find("mjOBJ_TENDON", spring + name)
                model.tendon_stiffness[tendon] = 0.0
                model.tendon_stiffnesspoly[tendon] = 0.0
        if laws["joint"]["stop_rad"] is not None:  # a spring with damping, below: MuJoCo's own moves away
            model.jnt_range[joints[2]] = (-1e3, 1e3)
        self.reset()

    def reset(self):
        """Forgets what the joint remembers; the state of MuJoCo is yours."""
        self.memory = [{"k_se": [-1.0, 0.0], "k_pe": [-1.0, 0.0]} for _ in SIDES]
        self.encoders = [0.0, 0.0]
        self.commands = []

    def step(self, torques):
        """Sets the torques of agonist, antagonist and joint [Nm], the laws, and makes one step."""
        self.command(torques)
        self.apply()
        self.mujoco.mj_step(self.model, self.data)

    def command(self, torques):
        """Commands take effect after the delay of the rig, of which most have none."""
        now = float(self.data.time)
        self.commands.append((now, list(torques)))
        due = now - self.laws["delay_s"] + 1e-9
        while len(self.commands) > 1 and self.commands[1][0] <= due:
            self.commands.pop(0)
        if self.commands[0][0] > due:
            return
        for motor, torque in zip(self.motors, self.commands[0][1]):
            self.data.ctrl[motor] = torque

    def apply(self):
        """Springs, friction, gravity and stop at the present state, for the next mj_step."""
        model, data, laws = self.model, self.data, self.laws
        (g1, g2), s = [laws[name]["ratio"] for name in SIDES], [laws[name]["capstan_scale"] for name in SIDES]
        self._follow_encoders()
        place = [float(data.qpos[i]) for i in self.places]
        speed = [float(data.qvel[i]) for i in self.dofs]
        pull = [self._spring(0, "k_se", s[0] * place[0] + g1 * place[2]), self._spring(1, "k_se", s[1] * place[1] - g2 * place[2])]
        for i, name in enumerate(SIDES):
            load = s[i] * pull[i] + self._spring(i, "k_pe", place[i])
            data.qfrc_applied[self.dofs[i]] = -load
            model.dof_frictionloss[self.dofs[i]] = gear_friction(laws[name]["gear"], load, speed[i], self._way(i, speed[i], load))
        joint = laws["joint"]
        data.qfrc_applied[self.dofs[2]] = g2 * pull[1] - g1 * pull[0] + self._outside(place[2], speed[2])
        model.dof_frictionloss[self.dofs[2]] = joint["friction_Nm"] + joint["tension_share"] * (g1 * pull[0] + g2 * pull[1])

    def read(self):
        """Angles of agonist, antagonist and joint as the encoders of the rig read them, without noise and steps [rad]."""
        self._follow_encoders()
        return [*self.encoders, float(self.data.qpos[self.places[2]]) + self.laws["joint"]["offset_rad"]]

    def _follow_encoders(self):
        """An encoder behind backlash stays until its capstan takes it along."""
        for i, name in enumerate(SIDES):
            theta, half = float(self.data.qpos[self.places[i]]), 0.5 * self.laws[name]["gear"]["backlash_rad"]
            self.encoders[i] = min(max(self.encoders[i], theta - half), theta + half)

    def _spring(self, side, name, x):
        return pull_spring(self.laws[SIDES[side]][name], self.memory[side][name], x)

    def _way(self, side, speed, load):
        """The way in which a capstan turns or, creeping at rest, is driven."""
        gear = self.laws[SIDES[side]]["gear"]
        limit = math.inf if gear["saturation_Nm"] is None else gear["saturation_Nm"]
        torque = min(limit, max(-limit, gear["torque_scale"] * float(self.data.ctrl[self.motors[side]])))
        return _sign(speed if abs(speed) > 1e-3 else torque - load)

    def _outside(self, q, speed):
        """Gravity and stop at the joint [Nm]."""
        joint = self.laws["joint"]
        torque = -joint["gravity_Nm"] * math.sin(q) if joint["gravity_Nm"] != 0.0 else 0.0
        inside = -1.0 if joint["stop_rad"] is None else abs(q) - joint["stop_rad"]
        if inside > 0.0:
            stiffness = joint["stop_stiffness_Nm_per_rad"]
            damping = 2.0 * joint["stop_damping"] * math.sqrt(stiffness * self.laws["joint_inertia_kgm2"])
            torque -= _sign(q) * stiffness * inside + damping * speed
        return torque
