"""A position-controlled servo: proportional loop, gear with friction and play, a link with weight that a cord may pull."""
import json
import math
import sys


def simulate(p, inputs):
    """Angle of the output at each row; it begins where the servo would hold it."""
    time, goal = inputs["t_s"], inputs["goal_rad"]
    pull = inputs.get("pull_Nm", [0.0] * len(time))
    stiffness, damping, play = p["stiffness_Nm_per_rad"], p["damping_Nms"], 0.5 * p["play_rad"]
    weight, centre = p["weight_Nm"], p["weight_angle_rad"]
    limit, most = p["torque_limit_Nm"], p["speed_limit_rad_per_s"]
    motor = output = inputs["begin_rad"][0]
    if stiffness <= 0.0 or damping <= 0.0:
        raise ValueError("stiffness and damping above 0")
    angles = []
    for i, t in enumerate(time):
        angles.append(output)
        step = time[i + 1] - t if i + 1 < len(time) else 0.0
        steps = 4 if step > 0.0 else 0
        h = step / max(1, steps)
        share = 1.0 - math.exp(-h * stiffness / damping)   # of the way to rest, which a loop without friction goes
        for _ in range(steps):
            load = pull[i] + weight * math.sin(output - centre)
            if abs(load) > p["output_friction_Nm"]:   # the load holds the output at one side of the play
                output = motor + math.copysign(play, load)
            else:
                output = min(max(output, motor - play), motor + play)
                load = 0.0
            drive = max(-limit, min(limit, stiffness * (goal[i] - output)))
            net = drive + load
            friction = p["coulomb_Nm"] + p["load_friction"] * abs(load)
            if abs(net) > friction:
                way = share * (net - math.copysign(friction, net)) / stiffness
                motor += max(-most * h, min(most * h, way))
    return {"angle_rad": angles}


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
