"""A law given by functions of Python: the error that it states is the error that it has."""

import fusee
import numpy as np
import pytest


def series(x):
    return 0.05 + 0.25 * x + 0.12 * x**2


def parallel(x):
    return 0.04 + 0.1 * np.expm1(0.9 * x)


def energy_of_series(x):
    return 0.05 * x + 0.125 * x**2 + 0.04 * x**3


def energy_of_parallel(x):
    return 0.04 * x + 0.1 * (np.expm1(0.9 * x) / 0.9 - x)


@pytest.mark.parametrize("given, curves", [("torque", (series, parallel)), ("energy", (energy_of_series, energy_of_parallel))])
def test_functions_become_a_law(profiles, tmp_path, given, curves):
    base = fusee.Profile(profiles / "measured_table.toml")
    made = fusee.law_from_functions(base, tmp_path / "mine.toml", *curves, (0.0, 2.0), given=given)
    assert made.relative_error <= 1e-4 and 8 <= made.knots <= 400
    law = fusee.resolve(made.profile.with_values({"law.lead_in_deg": 0.0})).law
    points = law.at_angle(np.linspace(0.001, law.angles[1] - 0.001, 97))
    assert np.max(np.abs(points.f_se - series(points.theta))) <= made.series_error + 1e-8
    assert np.max(np.abs(points.f_pe - parallel(points.theta))) <= made.parallel_error + 1e-8
    again = fusee.Profile(tmp_path / "mine.toml")
    assert again.sha256 == made.profile.sha256 and (tmp_path / "mine.csv").exists()


def test_files_are_not_replaced(profiles, tmp_path):
    base = fusee.Profile(profiles / "measured_table.toml")
    fusee.law_from_functions(base, tmp_path / "mine.toml", series, parallel, (0.0, 2.0))
    with pytest.raises(fusee.IoError):
        fusee.law_from_functions(base, tmp_path / "mine.toml", series, parallel, (0.0, 2.0))
    fusee.law_from_functions(base, tmp_path / "mine.toml", series, parallel, (0.0, 2.0), force=True)


@pytest.mark.parametrize(
    "changes",
    [
        {"series": lambda x: np.sqrt(x - 1.0)},
        {"series": lambda x: x[:3]},
        {"series": lambda x: np.where(x < 1.0, 0.1, 0.5)},
        {"angles": (1.0, 0.5)},
        {"given": "force"},
    ],
)
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_functions_that_are_no_law_are_refused(profiles, tmp_path, changes):
    arguments = {"series": series, "parallel": parallel, "angles": (0.0, 2.0)} | changes
    with pytest.raises(fusee.InvalidInput):
        fusee.law_from_functions(fusee.Profile(profiles / "measured_table.toml"), tmp_path / "mine.toml", **arguments)
    assert not list(tmp_path.glob("mine.*")), "nothing half-written"
