"""A law given as functions of Python: torques over the capstan's angle, as cams.

    python3 python/examples/function_law.py profiles/measured_table.toml
"""

import sys

import numpy as np

import fusee


def series(angle: "np.ndarray") -> "np.ndarray":
    """K_SE's torque [Nm] over the capstan's angle [rad]."""
    return 0.075 + 0.085 * angle + 0.055 * angle**2


def parallel(angle: "np.ndarray") -> "np.ndarray":
    """K_PE's torque [Nm]."""
    return 0.131 + 0.346 * np.expm1(0.596 * angle)


def main(path: str) -> None:
    law = fusee.law_from_functions(fusee.Profile(path), "function_law.toml", series, parallel, (0.0, 1.98))
    print(f"{law.knots} intervals; error {1e6 * law.series_error:.2g} and {1e6 * law.parallel_error:.2g} uNm, relative {law.relative_error:.1e}")
    made = fusee.make(law.profile.with_values({"k_se.spring.preload_rad": 1.1}))  # less: K_SE's contour is not convex
    for finding in made.findings:
        if finding.severity in ("error", "warning"):
            print(finding)
    for part in made.parts:
        print(f"{part.name}: arms {1e3 * part.arm.min():.2f} to {1e3 * part.arm.max():.2f} mm, {len(part.triangles)} triangles")


if __name__ == "__main__":
    main(sys.argv[1])
