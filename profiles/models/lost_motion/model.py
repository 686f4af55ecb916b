"""The end of each hold of one servo, or of two coupled ones, whose lever two cords pull to and fro and let go."""
import json
import math
import sys


def simulate(p, inputs, outputs=("first_rad", "second_rad")):
    """Angle of each output at each row. The last pull decides on which side of its goal the lever stays."""
    side, angles = 0.0, []
    for goal, pull in zip(inputs["goal_rad"], inputs["pull_Nm"]):
        side = math.copysign(1.0, pull) if pull else side
        angles.append(goal + 0.5 * side * p["loaded_rad" if pull else "slack_rad"])
    return {name: [angle + p[name.replace("_rad", "_zero_rad")] for angle in angles] for name in outputs}


def main():
    for line in sys.stdin:
        request = json.loads(line)
        answer = {"id": request["id"], "outputs": simulate(request["parameters"], request["inputs"], request["outputs"])}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
