"""Laws: known answers, and arrays that are the memory of C++."""

import gc

import fusee
import numpy as np
import pytest


@pytest.fixture
def curve(profiles):
    return fusee.resolve(profiles / "pnrvsa.toml").curve


def test_the_law_is_the_papers(profiles):
    profile = fusee.Profile(profiles / "pnrvsa.toml")
    law = fusee.resolve(profile).law
    tau = np.linspace(profile["law.start_torque_Nm"], profile["law.end_torque_Nm"], 7)
    points = law.at_load(tau)
    k, u, c, mu = (profile[key] for key in ("law.k_per_Nm_rad", "law.u_Nm", "law.c_Nm", "rig.gear_friction"))
    np.testing.assert_allclose(points.s, k * tau**2, rtol=1e-12)  # paper (16)
    np.testing.assert_allclose(points.transmission, u**2 / (mu * tau**2) + c / tau, rtol=1e-12)  # paper (11)
    np.testing.assert_allclose(points.f_se + points.f_pe, tau, rtol=1e-12)
    np.testing.assert_allclose(law.at_angle(points.theta).tau, tau, rtol=1e-9)


def test_arrays_are_views_of_one_memory(curve):
    tau = curve.tau
    assert not tau.flags.owndata and not tau.flags.writeable
    assert np.shares_memory(tau, curve.tau)
    address = tau.__array_interface__["data"][0]
    assert curve.tau.__array_interface__["data"][0] == address
    assert curve.theta.__array_interface__["data"][0] == address + 8, "the next member of the same struct"
    assert tau.strides == (80,), "one struct of ten doubles a row"
    with pytest.raises(ValueError):
        tau[0] = 1.0


def test_arrays_outlive_their_owner(profiles):
    design = fusee.resolve(profiles / "pnrvsa.toml")
    curve = design.curve
    kept, tau = curve.tau.copy(), curve.tau
    del design, curve
    gc.collect()
    _ = [np.full(10_000, 7.0) for _ in range(50)]  # would overwrite memory that was freed
    np.testing.assert_array_equal(tau, kept)


def test_a_law_that_is_no_pair_of_springs_is_a_result(profiles):
    design = fusee.resolve(fusee.Profile(profiles / "pnrvsa.toml").with_values({"law.c_Nm": 3.0}))
    assert not design.ok and design.law is None and design.curve is None
    assert design.findings[0].rule == "law.transmission" and design.findings[0].severity == "error"
    assert design.findings[0].suggestion and "law.transmission" in str(design.findings[0])


def test_a_table_is_smoothed_as_in_the_profile(profiles):
    x = np.linspace(0.0, 1.0, 50)
    spring = fusee.tabulated(x, 0.2 + 0.3 * x, knots=8, smoothing=0.0)
    assert spring.domain == (0.0, 1.0)
    np.testing.assert_allclose(spring.torque([0.0, 0.5]), [0.2, 0.35], atol=1e-9)
    np.testing.assert_allclose(spring.stiffness(np.array([0.25])), [0.3], atol=1e-7)
    np.testing.assert_allclose(spring.energy(1.0) - spring.energy(0.0), 0.35, atol=1e-9)
    with pytest.raises(fusee.InvalidInput):
        fusee.tabulated(x[:3], x[:3])
