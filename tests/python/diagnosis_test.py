"""Cases from arrays and from folders, diagnosis and prediction."""

import json

import fusee
import numpy as np
import pytest

EFFECT = {"effects": [{"id": "gear.coulomb", "side": "agonist", "parameter": {"value": 0.08, "unit": "Nm"}}]}


@pytest.fixture
def template(profiles):
    made = fusee.case_template(profiles / "pnrvsa.toml")
    assert made.ok and made.findings == []
    return made


def measured(template, effects, experiments):
    """What a rig with the effects would show, with the scatter of its sensors."""
    random = np.random.default_rng(1)
    rows = fusee.predict(template, fusee.Diagnosis.parse(json.dumps(effects)))
    taken = {name: dict(rows[name]) for name in experiments}
    for columns in taken.values():
        for name in ("q_low_rad", "q_high_rad", "q_rad", "theta_agonist_rad", "theta_antagonist_rad"):
            if name in columns:
                columns[name] = columns[name] + random.normal(0.0, 6e-4, len(columns[name]))
        if "load_torque_Nm" in columns:
            columns["load_torque_Nm"] = columns["load_torque_Nm"] * (1.0 + random.normal(0.0, 0.005, len(columns["load_torque_Nm"])))
    return taken


def test_arrays_are_the_case_of_their_folder(template, tmp_path):
    rows = measured(template, EFFECT, ["breakaway", "cocontraction"])
    case = template.filled(rows)
    assert case.name == "pnrvsa" and set(case.experiments) == {"breakaway", "cocontraction"}
    np.testing.assert_array_equal(case.experiments["cocontraction"]["q_rad"], rows["cocontraction"]["q_rad"])
    again = fusee.Case.from_arrays("pnrvsa", template.rig, rows, sensors=template.sensors, tolerance=template.tolerance, protocol=template.protocol)
    assert again.sha256 == case.sha256


def test_the_effect_is_found(template):
    case = template.filled(measured(template, EFFECT, ["breakaway", "dead_band", "cocontraction"]))
    steps = []
    found = fusee.diagnose(case, progress=lambda done, total, what: steps.append((done, total)))
    assert steps and found.verdict == "identified"
    effect = found.effects[0]
    assert (effect.id, effect.side) == ("gear.coulomb", "agonist") and effect.ci95[0] < 0.08 < effect.ci95[1] and effect.unit == "Nm"
    assert found.gap.after < found.gap.before
    trace = found.traces[0]
    assert trace.x.shape == trace.measured.shape == trace.sigma.shape and not trace.x.flags.writeable
    assert fusee.Diagnosis.parse(found.json()).effects[0].id == "gear.coulomb"
    after = fusee.predict(case, found)
    assert set(after) == set(case.experiments)


def test_predictions_at_other_inputs(template):
    inputs = {"breakaway": {"side": ["agonist", "antagonist"], "direction": ["drive", "drive"], "motor_torque_Nm": np.array([0.9, 0.9])}}
    rows = fusee.predict(template, fusee.Diagnosis.parse(json.dumps(EFFECT)), inputs)
    nominal = fusee.predict(template, None, inputs)
    loads = rows["breakaway"]["load_torque_Nm"]
    assert loads[0] < nominal["breakaway"]["load_torque_Nm"][0], "more friction on the agonist"
    assert loads[1] == pytest.approx(nominal["breakaway"]["load_torque_Nm"][1], rel=1e-12)


def test_faults_of_arrays_are_named_like_those_of_files(template):
    rows = measured(template, EFFECT, ["dead_band"])
    rows["dead_band"]["q_low_rad"] = np.rad2deg(rows["dead_band"]["q_low_rad"])
    with pytest.raises(fusee.InvalidInput, match="degrees") as caught:
        template.filled(rows)
    assert caught.value.key == "q_low_rad" and caught.value.file == "pnrvsa/dead_band.csv" and caught.value.line >= 2
    with pytest.raises(fusee.InvalidInput, match="rows"):
        template.filled({"dead_band": {"cocontraction_Nm": [1.0, 2.0], "q_low_rad": [0.1]}})
    with pytest.raises(fusee.InvalidInput):
        template.filled(template.experiments)  # nothing was measured: NaN
    with pytest.raises(fusee.InvalidInput, match="capstan_radius_m"):
        fusee.Case.from_arrays("x", {**template.rig, "capstan_radius_m": 17.0}, {})
    with pytest.raises(TypeError):
        fusee.diagnose(template)


def test_a_law_that_is_refused_has_no_case(profiles):
    refused = fusee.case_template(fusee.Profile(profiles / "pnrvsa.toml").with_values({"law.c_Nm": 3.0}))
    assert not refused.ok and refused.findings and refused.experiments == {} and refused.rig == {}
    with pytest.raises(fusee.InvalidInput):
        refused.filled({})
