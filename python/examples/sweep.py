"""A sweep: how the dead-band and the cams change with the stiffness parameter k of the law. Draws sweep.png where matplotlib is installed.

    python3 python/examples/sweep.py profiles/pnrvsa.toml
"""

import sys

import numpy as np

import fusee


def swept(profile: fusee.Profile, values: "np.ndarray") -> "list[tuple[float, fusee.Simulation, fusee.Made]]":
    rows = []
    for k in values:
        changed = profile.with_values({"law.k_per_Nm_rad": float(k)})
        rows.append((float(k), fusee.simulate(changed, levels=9), fusee.make(changed)))
    return rows


def drawn(rows: "list[tuple[float, fusee.Simulation, fusee.Made]]", file: str) -> bool:
    try:
        import matplotlib
    except ImportError:
        return False
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for k, simulation, made in rows:
        left.plot(simulation.tau, np.rad2deg(simulation.exact_width), label=f"k = {k:.3g}")
        if made.parts:
            x, y, _ = 1e3 * made.parts[1].contour().T
            right.plot(x, y, label=f"k = {k:.3g}" + ("" if made.ok else ", refused"))
    left.set(xlabel="co-contraction [Nm]", ylabel="dead-band, full width [deg]")
    right.set(xlabel="x [mm]", ylabel="y [mm]", title="K_PE, cable's centreline", aspect="equal")
    left.legend()
    figure.savefig(file, dpi=120)
    return True


def main(path: str) -> None:
    profile = fusee.Profile(path)
    rows = swept(profile, profile["law.k_per_Nm_rad"] * np.array([0.85, 0.925, 1.0]))
    for k, simulation, made in rows:
        width = np.rad2deg(simulation.exact_width[-1]) if simulation.ok else float("nan")
        errors = [finding.rule for finding in made.findings if finding.severity == "error"]
        print(f"k = {k:.3f} 1/(Nm rad): dead-band {width:.1f} deg at the greatest co-contraction, {', '.join(errors) or 'can be made'}")
    print("sweep.png" if drawn(rows, "sweep.png") else "no picture: matplotlib is not installed")


if __name__ == "__main__":
    main(sys.argv[1])
