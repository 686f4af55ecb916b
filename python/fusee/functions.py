"""A spring law from functions of Python."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

from fusee import _fusee
from fusee.errors import InvalidInput

Curve = Callable[[NDArray[np.float64]], Any]


@dataclass(frozen=True)
class FunctionLaw:
    """A profile whose law was sampled from two functions, and how far the law is from them."""

    profile: _fusee.Profile
    series_error: float
    """Greatest difference of K_SE's torque from its function, between the samples too [Nm]."""
    parallel_error: float
    """The same of K_PE [Nm]."""
    relative_error: float
    """The greater of both, over the greatest torque of its spring."""
    knots: int
    """Intervals of the quintic spline."""


def _values(name: str, curve: Curve, x: NDArray[np.float64]) -> NDArray[np.float64]:
    y = np.asarray(curve(x), dtype=np.float64)
    if y.shape != x.shape:
        y = np.broadcast_to(y, x.shape) if y.ndim == 0 else y
    if y.shape != x.shape or not np.all(np.isfinite(y)):
        raise InvalidInput(f"{name}: not one finite number for each angle", name, repr(y.shape), f"{x.size} finite numbers")
    return y


def _slope(name: str, energy: Curve, x: NDArray[np.float64]) -> NDArray[np.float64]:
    """dU/dx [Nm] by the five-point formula; at both ends on one side, so that no angle lies outside."""
    h = (x[-1] - x[0]) * 1e-3
    slopes = np.empty_like(x)
    centre = (x >= x[0] + 2 * h) & (x <= x[-1] - 2 * h)
    u = [_values(name, energy, x[centre] + k * h) for k in (-2, -1, 1, 2)]
    slopes[centre] = (u[0] - 8 * u[1] + 8 * u[2] - u[3]) / (12 * h)
    for side, step in ((x < x[0] + 2 * h, h), (x > x[-1] - 2 * h, -h)):
        v = [_values(name, energy, x[side] + k * step) for k in range(5)]
        slopes[side] = (-25 * v[0] + 48 * v[1] - 36 * v[2] + 16 * v[3] - 3 * v[4]) / (12 * step)
    return slopes


def _fitted(
    curves: dict[str, Curve], given: str, x: NDArray[np.float64], knots: int | None, tolerance: float
) -> tuple[dict[str, NDArray[np.float64]], dict[str, float], float, int]:
    """Torques at x, greatest errors of their splines between the samples too, the greater one relative, and the number of intervals."""
    torque = _values if given == "torque" else _slope
    between = np.linspace(x[0], x[-1], 4 * x.size - 3)
    sampled = {name: torque(name, curve, x) for name, curve in curves.items()}
    exact = {name: torque(name, curve, between) for name, curve in curves.items()}

    def misfits(count: int) -> dict[str, float]:
        return {name: float(np.max(np.abs(_fusee.tabulated(x, sampled[name], count, 0.0).torque(between) - exact[name]))) for name in curves}

    def relative(errors: dict[str, float]) -> float:
        return max(errors[name] / float(np.max(np.abs(exact[name]))) for name in curves)

    count = knots or 8
    errors = misfits(count)
    while knots is None and relative(errors) > tolerance and 2 * count <= min(400, x.size // 2):
        count *= 2
        errors = misfits(count)
    found = relative(errors)
    if not found <= tolerance:
        text = f"law_from_functions: {count} intervals leave an error of {found:.2g}; allowed: {tolerance:g}; are the functions smooth?"
        raise InvalidInput(text, "tolerance", f"{found:.2g}", f"at most {tolerance:g}")
    return sampled, errors, found, count


def law_from_functions(
    profile: _fusee.Profile,
    file: str | os.PathLike[str],
    series: Curve,
    parallel: Curve,
    angles: tuple[float, float],
    *,
    given: str = "torque",
    start_torque: float | None = None,
    end_torque: float | None = None,
    rows: int = 801,
    knots: int | None = None,
    tolerance: float = 1e-4,
    force: bool = False,
) -> FunctionLaw:
    """The profile with a law given by functions of the capstan's angle.

    `series` and `parallel` map an array of angles [rad] to the torque of K_SE and K_PE at the capstan [Nm], or, with given="energy", to
    their energy [J]. The functions are sampled at `rows` angles and become the law of kind "table": a quintic spline without smoothing
    (its weight is 0, because functions have no noise). Its intervals are doubled from 8 until both torques are within `tolerance` of
    their functions, relative to the greatest torque, or are `knots`. The error that remains is in the result. Torques of an energy are
    its slope by the five-point formula. The law ends at the loads of both angles unless start_torque and end_torque name other loads.

    Writes `file` (a new profile) and its rows beside it as CSV. Raises InvalidInput if the functions do not give finite numbers or
    `knots` intervals do not reach the tolerance; IoError if a file exists, unless `force`.
    """
    if given not in ("torque", "energy"):
        raise InvalidInput(f"given: {given}: allowed: torque or energy", "given", given, "torque or energy")
    if not 0.0 <= angles[0] < angles[1]:
        raise InvalidInput(f"angles: {angles}", "angles", repr(angles), "two rising angles from 0 on [rad]")
    x = np.linspace(angles[0], angles[1], rows)
    sampled, errors, relative, count = _fitted({"series": series, "parallel": parallel}, given, x, knots, tolerance)
    total = [sum(float(_fusee.tabulated(x, y, count, 0.0).torque(np.array([end]))[0]) for y in sampled.values()) for end in angles]
    changed = profile.with_table(
        file,
        x,
        sampled["series"],
        sampled["parallel"],
        start_torque=total[0] * (1.0 + 1e-9) if start_torque is None else start_torque,
        end_torque=total[1] * (1.0 - 1e-9) if end_torque is None else end_torque,
        knots=count,
        smoothing=0.0,
        force=force,
    )
    return FunctionLaw(changed, errors["series"], errors["parallel"], relative, count)
