"""A motor with a gear that swings a pendulum: torque constant, resistance and friction, all at the output."""
import json
import math
import sys


def simulate(p, inputs):
    """Angle and current at each row, from rest, hanging down; the voltage is held from row to row."""
    time, voltage = inputs["t_s"], inputs["voltage_V"]
    mass, length, kt = p["mass_kg"], p["length_m"], p["torque_constant_Nm_per_A"]
    inertia = mass * length * length + p["armature_kgm2"]
    angle = speed = 0.0
    outputs = {"angle_rad": [], "current_A": []}
    for i, t in enumerate(time):
        outputs["angle_rad"].append(angle)
        outputs["current_A"].append((voltage[i] - kt * speed) / p["resistance_ohm"])
        steps = 6
        h = (time[i + 1] - t) / steps if i + 1 < len(time) else 0.0
        for _ in range(steps):
            drive = kt * (voltage[i] - kt * speed) / p["resistance_ohm"]
            weight = mass * 9.81 * length * math.sin(angle)
            dry = p["coulomb_Nm"] + p["load_friction"] * abs(weight)
            cogging = p["cogging_Nm"] * math.sin(p["cogging_count"] * angle)
            friction = dry * math.tanh(speed / 0.02) + p["viscous_Nms"] * speed
            speed += h * (drive - weight - friction - cogging) / inertia
            angle += h * speed
    return outputs


def main():
    for line in sys.stdin:
        request = json.loads(line)
        try:
            outputs = simulate(request["parameters"], request["inputs"])
            answer = json.dumps({"id": request["id"], "outputs": outputs}, allow_nan=False)
        except (ArithmeticError, ValueError) as why:
            answer = json.dumps({"id": request["id"], "error": str(why)})
        print(answer, flush=True)


if __name__ == "__main__":
    main()
