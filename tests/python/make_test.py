"""Parts in memory and in files, rules, simulation."""

import gc

import fusee
import numpy as np
import pytest


def test_meshes_are_the_memory_of_cpp(profiles):
    made = fusee.make(profiles / "pnrvsa.toml")
    assert made.ok and made.folder is None and [part.name for part in made.parts] == ["k_se", "k_pe"]
    part = made.parts[1]
    points, triangles = part.points_mm, part.triangles
    assert points.shape[1] == 3 and points.dtype == np.float64 and triangles.dtype == np.uint32
    assert np.shares_memory(points, made.parts[1].points_mm), "a second part object shows the same mesh"
    assert not points.flags.owndata and not points.flags.writeable
    volume = part.volume_mm3
    assert part.closed
    del made, part
    gc.collect()
    _ = [np.full((10_000, 3), 7.0) for _ in range(50)]  # would overwrite memory that was freed
    a, b, c = (points[triangles[:, i]] for i in range(3))
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0 == pytest.approx(volume, rel=1e-12)


def test_arms_are_the_laws(profiles):
    made = fusee.make(profiles / "pnrvsa.toml")
    pe = made.parts[1]
    law = fusee.resolve(profiles / "pnrvsa.toml").law.at_load(pe.tau)
    np.testing.assert_allclose(pe.arm * pe.tension, law.f_pe, rtol=1e-9)  # torque = arm times tension
    contour = pe.contour(721)
    assert contour.shape == (721, 3)
    np.testing.assert_allclose(contour[0], contour[-1], atol=1e-9)  # planar: the contour closes
    np.testing.assert_allclose(np.cos(pe.psi) * 0 + pe.h, pe.h)
    assert np.all(pe.rho > 0), "convex"


def test_files_are_those_of_the_program(profiles, tmp_path):
    made = fusee.make(profiles / "pnrvsa.toml", tmp_path / "out")
    assert made.ok and made.folder == tmp_path / "out" / "pnrvsa"
    assert (made.folder / "k_pe.stl").exists() and (made.folder / "report.json").exists()
    assert [part.name for part in made.parts] == ["k_se", "k_pe", "k_se_mirrored", "k_pe_mirrored"]
    assert made.arm_error < 1e-3 and made.dead_band_error < 1e-2
    faces = (made.folder / "k_pe.stl").stat().st_size
    assert faces == 84 + 50 * len(made.parts[1].triangles), "the STL has the triangles of the array"
    for ending in ("stl", "3mf", "step"):
        file = made.parts[0].export(tmp_path / f"k_se.{ending}")
        assert file.read_bytes() == (made.folder / f"k_se.{ending}").read_bytes(), ending
    with pytest.raises(fusee.IoError, match="already exists"):
        made.parts[0].export(tmp_path / "k_se.stl")
    with pytest.raises(fusee.InvalidInput, match=".stl, .3mf or .step"):
        made.parts[0].export(tmp_path / "k_se.obj")


def test_a_design_that_cannot_be_made_is_a_result(profiles, tmp_path):
    thin = fusee.Profile(profiles / "pnrvsa.toml").with_values({"groove.rib_mm": 0.4})
    made = fusee.make(thin, tmp_path / "out")
    assert not made.ok and made.parts == [] and made.folder is None and not (tmp_path / "out" / "pnrvsa").exists()
    errors = [finding for finding in made.findings if finding.severity == "error"]
    assert errors and all(finding.what and finding.suggestion for finding in errors)
    assert np.isnan(made.arm_error) and made.law is None
    checked = fusee.check(thin)
    assert not checked.ok and not checked.processes[0].ok
    wire = fusee.check(fusee.Profile(profiles / "pnrvsa.toml").with_values({"k_se.spring.wire_mm": 0.9}))
    rate = next(f for f in wire.processes[0].findings if f.rule == "spring.rate" and f.severity == "error")
    assert "k_se.spring.active_coils" in rate.changes[0], "changes are keys with values"


def test_processes_are_compared(profiles):
    checked = fusee.check(profiles / "pnrvsa.toml", ["fdm", "mill"])
    assert [one.process for one in checked.processes] == ["fdm", "mill"]
    assert checked.ok and {part.name for part in checked.processes[0].parts} == {"k_se", "k_pe"}
    with pytest.raises(fusee.InvalidInput):
        fusee.check(profiles / "pnrvsa.toml", ["steam"])


def test_simulation_gives_arrays_over_the_levels(profiles):
    result = fusee.simulate(profiles / "pnrvsa.toml", levels=5, at=[(1.0, 0.9, 0.0)])
    assert result.ok and result.tau.shape == (5,) and result.covered.dtype == bool
    np.testing.assert_allclose(np.rad2deg(result.exact_width[[0, -1]]), [75.5, 20.4], atol=0.05)  # README
    np.testing.assert_allclose(result.sensitivity, np.swapaxes(result.sensitivity, 1, 2), atol=1e-9)  # of an energy
    assert np.shares_memory(result.tau, result.tau) and not result.tau.flags.writeable
    row = result.equilibria[0]
    assert row.z.shape == (3,) and row.dead_band > 0.0 and row.torque.tolist() == [1.0, 0.9, 0.0]
    assert len(result.release_path["up"]["q"]) > 10
    assert result.condition_6_verdict in ("holds", "within rounding")


def test_an_equilibrium_that_does_not_exist_is_a_finding(profiles):
    result = fusee.simulate(profiles / "pnrvsa.toml", levels=2, at=[(1.0, 1.0, 100.0)])
    assert not result.ok and result.findings[-1].severity == "error" and len(result.tau) == 2


def test_wrong_arguments_name_themselves(profiles):
    with pytest.raises(fusee.InvalidInput, match="via"):
        fusee.make(profiles / "pnrvsa.toml", via="magic")
    with pytest.raises(TypeError):
        fusee.make(17)
