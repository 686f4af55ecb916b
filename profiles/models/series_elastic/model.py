"""A motor that turns a link through a spring: J_m, J_l, k, viscous friction on both sides."""
import json
import math
import sys


def simulate(p, inputs):
    """Motor and link angle at each row, from rest; the torque is held from row to row."""
    time, torque = inputs["t_s"], inputs["torque_Nm"]
    motor = link = motor_speed = link_speed = 0.0
    half_gap, angles = 0.5 * p["play_rad"], {"motor_rad": [], "link_rad": []}
    for i, t in enumerate(time):
        angles["motor_rad"].append(motor)
        angles["link_rad"].append(link)
        steps = 8
        h = (time[i + 1] - t) / steps if i + 1 < len(time) else 0.0
        for _ in range(steps):
            twist = motor - link
            twist -= max(-half_gap, min(half_gap, twist))  # nothing within the play
            spring = p["spring_Nm_per_rad"] * twist * (1.0 + p["hardening"] * twist * twist)
            friction = p["coulomb_Nm"] * math.tanh(motor_speed / 0.02) + p["motor_viscous_Nms"] * motor_speed
            motor_speed += h * (torque[i] - friction - spring) / p["motor_inertia_kgm2"]
            link_speed += h * (spring - p["link_viscous_Nms"] * link_speed) / p["link_inertia_kgm2"]
            motor += h * motor_speed
            link += h * link_speed
    return angles


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
