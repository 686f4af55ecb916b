"""Searches and fixes: the same as the program's, with progress."""

import fusee
import numpy as np
import pytest


def test_algorithm_1_finds_springs(profiles):
    steps = []
    found = fusee.design(profiles / "pnrvsa.toml", method="algorithm_1", population=16, generations=12, progress=lambda *step: steps.append(step))
    assert found.ok and [generation for generation, _ in steps] == list(range(13))[-len(steps) :]
    assert np.all(np.diff(found.history) <= 0) and found.history.shape == (13,)
    (name, profile), = found.profiles.items()
    assert name == "pnrvsa-best.toml" and fusee.resolve(profile).ok
    assert found.law.tau.shape == found.law.theta.shape and found.folder is None
    assert any(figure.name and figure.unit for figure in found.figures)


def test_files_of_a_search(profiles, tmp_path):
    found = fusee.design(profiles / "pnrvsa.toml", method="algorithm_1", population=16, generations=4, out=tmp_path / "out")
    assert found.folder == tmp_path / "out" / "pnrvsa-design" and (found.folder / "design.json").exists()


def test_an_exception_of_progress_ends_the_search(profiles):
    def refuse(generation, cost):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        fusee.design(profiles / "pnrvsa.toml", population=16, generations=100_000, progress=refuse)


def test_unknown_methods_are_refused(profiles):
    with pytest.raises(fusee.InvalidInput, match="algorithm_1"):
        fusee.design(profiles / "pnrvsa.toml", method="guess")


def test_a_broken_profile_is_fixed(profiles):
    fixed = fusee.fix(profiles / "pnrvsa.toml")
    assert fixed.ok and fixed.end == "nothing to do" and fixed.profile is None and fixed.changes == []
    thin = fusee.Profile(profiles / "pnrvsa.toml").with_values({"groove.rib_mm": 0.4})
    fixed = fusee.fix(thin, keep=["rig"])
    assert fixed.ok and fixed.end == "fixed" and fixed.changes
    assert fusee.check(fixed.profile).ok and not fusee.check(thin).ok
    assert fixed.changes[0].because.severity == "error" and repr(fixed.changes[0])
    with pytest.raises(fusee.InvalidInput, match="keep"):
        fusee.fix(thin, keep=["rgi"])
