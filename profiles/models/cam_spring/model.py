"""A cam that pushes a spring, turned slowly by hand: torque at its shaft and force at its follower."""
import json
import math
import sys


def simulate(p, inputs):
    """Torque and force at each row; nothing has inertia, so that only the angle and its speed count."""
    time, angles = inputs["t_s"], inputs["angle_rad"]
    outputs = {"torque_Nm": [], "force_N": []}
    for i, angle in enumerate(angles):
        first, last = max(0, i - 1), min(len(angles) - 1, i + 1)
        speed = (angles[last] - angles[first]) / (time[last] - time[first])
        lift = 0.5 * p["lift_m"] * (1.0 - math.cos(angle))
        arm = 0.5 * p["lift_m"] * math.sin(angle)  # d lift / d angle
        pressed = max(0.0, p["preload_m"] + lift)
        force = p["rate_N_per_m"] * pressed * (1.0 + p["hardening_per_m"] * pressed)
        opposing = math.tanh(speed / 0.02)
        force_up = force * (1.0 + p["slide_friction"] * opposing * math.copysign(1.0, arm))
        outputs["force_N"].append(force)
        outputs["torque_Nm"].append(force_up * arm + p["bearing_Nm"] * opposing)
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
