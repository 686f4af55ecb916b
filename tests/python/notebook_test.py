"""A session as in a notebook: cell after cell in one namespace, and what each cell shows."""

import ast
import sys
import types

import fusee
import numpy as np
import pytest

CELLS = [
    """
import fusee
profile = fusee.Profile("profiles/pnrvsa.toml")
made = fusee.make(profile)
made
""",
    """
mesh = made.parts[1].to_trimesh()
mesh.vertices.shape, mesh.metadata["units"]
""",
    """
step = made.parts[1].export("k_pe.step")
stl = made.parts[1].export("k_pe.stl")
step.name, stl.stat().st_size
""",
    """
budget = fusee.budget(profile, draws=200)
budget.parts[0].worst.band_percent
""",
    """
fusee.check(profile.with_values({"groove.rib_mm": 0.4}))
""",
]


class Trimesh:
    """Takes what trimesh.Trimesh takes."""

    def __init__(self, vertices, faces, process, metadata):
        assert not process and faces.max() < len(vertices)
        self.vertices, self.faces, self.metadata = np.array(vertices), np.array(faces), metadata


def shown_by(cell, names):
    """The value of the cell's last expression, as a notebook shows it."""
    tree = ast.parse(cell)
    last = ast.Expression(tree.body.pop().value)
    exec(compile(tree, "cell", "exec"), names)
    return eval(compile(last, "cell", "eval"), names)


def test_a_session(profiles, monkeypatch):
    monkeypatch.setitem(sys.modules, "trimesh", types.SimpleNamespace(Trimesh=Trimesh))
    names = {}
    shown = [shown_by(cell, names) for cell in CELLS]
    page = shown[0]._repr_html_()
    assert "<b>pnrvsa</b>" in page and "75.5 to 20.4 deg" in page and "cable.bend_ratio" in page and "<script" not in page
    assert shown[1] == (names["made"].parts[1].points_mm.shape, "mm")
    assert shown[2][0] == "k_pe.step" and shown[2][1] == 84 + 50 * len(names["made"].parts[1].triangles)
    assert b"ISO-10303-21" in names["step"].read_bytes()[:20]
    assert names["budget"].name == "pnrvsa" and shown[3][0] < 0.0 < shown[3][1]
    assert "pnrvsa by fdm" in shown[4]._repr_html_() and ">error<" in shown[4]._repr_html_()


def test_without_trimesh_the_message_says_what_to_install(profiles, monkeypatch):
    monkeypatch.setitem(sys.modules, "trimesh", None)
    part = fusee.make(profiles / "pnrvsa.toml").parts[0]
    with pytest.raises(ImportError, match="pip install trimesh"):
        part.to_trimesh()


def test_a_diagnosis_is_shown(profiles):
    effect = '{"id": "gear.coulomb", "side": "agonist", "parameter": {"value": 0.1, "ci95": [0.09, 0.11], "unit": "Nm"}, "probability": 1}'
    page = fusee.Diagnosis.parse('{"verdict": "identified", "effects": [' + effect + "]}")._repr_html_()
    assert "identified" in page and "gear.coulomb on agonist" in page and "0.1 Nm (0.09 to 0.11)" in page


class Frame:
    """Table with named columns, as a DataFrame is one."""

    def __init__(self, columns):
        self.data, self.columns = columns, list(columns)

    def __getitem__(self, name):
        return self.data[name]


def test_a_case_from_a_frame_is_that_from_arrays(profiles):
    template = fusee.case_template(profiles / "pnrvsa.toml")
    rows = fusee.predict(template)["breakaway"]
    rig, sensors = template.rig, template.sensors
    plain = fusee.Case.from_arrays("bench", rig, {"breakaway": rows}, sensors=sensors)
    logged = Frame({("Last" if name == "load_torque_Nm" else name): column for name, column in rows.items()} | {"note": [1.0] * 96})
    case = fusee.Case.from_frame(logged, "bench", rig, experiment="breakaway", columns={"load_torque_Nm": "Last"}, sensors=sensors)
    np.testing.assert_array_equal(case.experiments["breakaway"]["load_torque_Nm"], plain.experiments["breakaway"]["load_torque_Nm"])
    both = fusee.Case.from_frame({"breakaway": logged}, "bench", rig, columns={"breakaway": {"load_torque_Nm": "Last"}}, sensors=sensors)
    np.testing.assert_array_equal(both.experiments["breakaway"]["load_torque_Nm"], plain.experiments["breakaway"]["load_torque_Nm"])
    with pytest.raises(fusee.InvalidInput, match="did you mean Last"):
        fusee.Case.from_frame(logged, "bench", rig, experiment="breakaway", columns={"load_torque_Nm": "Lats"}, sensors=sensors)
    with pytest.raises(fusee.InvalidInput, match="experiment"):
        fusee.Case.from_frame(logged, "bench", rig)
