"""A function of Python as a model: its diagnosis, its refusals, its exceptions."""

import fusee
import numpy as np
import pytest

PARAMETERS = {"rate_N_per_m": {"nominal": 1000.0, "tolerance": 0.02}, "friction_N": {"nominal": 0.0}}
EFFECTS = {"friction": {"frees": "friction_N", "usual": 1.0, "range": [0.0, 10.0], "meaning": "The slide rubs.", "remedy": "Oil it."}}


def pulled(experiment, run, parameters, inputs):
    """F = k x + f sign(v)"""
    assert experiment == "pull" and run in (0, 1, 2)
    x = inputs["x_m"]
    return {"force_N": parameters["rate_N_per_m"] * x + parameters["friction_N"] * np.sign(np.gradient(x))}


def runs(friction):
    random = np.random.default_rng(4)
    time = np.arange(0.0, 3.0, 0.1)
    logs = []
    for phase in (0.0, 1.0, 2.0):
        x = 0.02 * np.sin(4.0 * time + phase)
        force = pulled("pull", 0, {"rate_N_per_m": 1010.0, "friction_N": friction}, {"x_m": x})["force_N"]
        logs.append({"t_s": time, "x_m": x, "force_N": force + random.normal(0.0, 0.1, len(x))})
    return logs


def model(simulate=pulled, friction=0.8, **experiment):
    pull = {"runs": runs(friction), "inputs": ["t_s", "x_m"], "outputs": {"force_N": 0.1}} | experiment
    return fusee.Model(simulate, {"pull": pull}, PARAMETERS, EFFECTS, name="spring")


def test_the_effect_is_found():
    own = model()
    assert own.name == "spring"
    assert all("the noise of force_N" in remark for remark in own.remarks), "jumps of friction in short runs look like noise"
    steps = []
    found = fusee.diagnose(own, progress=lambda done, total, what: steps.append(done))
    assert steps and found.verdict == "identified"
    effect = found.effects[0]
    assert effect.id == "friction" and effect.ci95[0] < 0.8 < effect.ci95[1] and effect.unit == "N"
    assert found.json() == fusee.diagnose(own, jobs=3).json()


def test_the_cause_holds_on_another_unit():
    found = fusee.diagnose(model(), against=model(friction=0.8))
    (cause,) = found.against.causes
    assert cause.id == "friction" and cause.survival == "agrees" and found.against.verdict == "identified"
    assert found.against.gap.carried < found.against.gap.before
    assert found.absorption.parameters["rate_N_per_m"].unit == "N_per_m" and "friction" in found.absorption.sentence
    assert fusee.diagnose(model(), against=model(friction=0.0)).against.causes[0].survival == "gone"
    with pytest.raises(fusee.InvalidInput, match="against"):
        fusee.diagnose(model(), against="a folder")


def test_nothing_is_found_where_nothing_is_wrong():
    assert fusee.diagnose(model(friction=0.0)).effects == []


def test_a_refusal_is_a_hypothesis_that_is_out():
    def simulate(experiment, run, parameters, inputs):
        if parameters["friction_N"] > 0.0:
            raise fusee.Refusal("no friction here")
        return pulled(experiment, run, parameters, inputs)

    assert "friction" not in [effect.id for effect in fusee.diagnose(model(simulate)).effects]


def test_what_the_function_raises_comes_out():
    def simulate(experiment, run, parameters, inputs):
        raise ZeroDivisionError("the spring broke")

    with pytest.raises(ZeroDivisionError, match="the spring broke"):
        fusee.diagnose(model(simulate))


def test_wrong_answers_are_named():
    for answer, words in (([], "list"), ({}, "without the output force_N"), ({"force_N": [1.0]}, "1 values"),
                          ({"force_N": "none"}, "no numbers"), ({"force_N": np.full(30, np.nan)}, "nan")):
        with pytest.raises(fusee.InvalidInput, match=words):
            fusee.diagnose(model(lambda *question: answer))


def test_wrong_descriptions_are_named():
    with pytest.raises(fusee.InvalidInput, match="outputs"):
        model(outputs={})
    with pytest.raises(fusee.InvalidInput, match="y_m"):
        model(inputs=["t_s", "y_m"])
    with pytest.raises(fusee.InvalidInput, match="runs"):
        fusee.Model(pulled, {"pull": {"inputs": ["x_m"], "outputs": {"force_N": 0.1}}}, PARAMETERS)
    with pytest.raises(fusee.InvalidInput, match="parameters"):
        fusee.Model(pulled, {"pull": {"runs": runs(0.0), "inputs": ["x_m"], "outputs": {"force_N": 0.1}}}, {})
