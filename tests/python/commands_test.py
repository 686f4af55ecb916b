"""The commands whose results are tables or files; wrong arguments in words; docstrings for Python."""

import dataclasses
import inspect
import json
import os
import re
import sqlite3
import subprocess

import fusee
import numpy as np
import pytest

PROGRAM = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(fusee.__file__))), "bin", "fusee")


def result_of(*words):
    return json.loads(subprocess.run([PROGRAM, *words, "--json"], capture_output=True, text=True, check=True).stdout)["result"]


def assert_same(found, json, path):
    """A result has every member of the program's JSON, as an attribute of the same value; null is NaN or None."""
    if dataclasses.is_dataclass(found):
        fields = {field.name for field in dataclasses.fields(found)}
        assert fields == set(json) - {"fusee"}, path
        for name in fields:
            assert_same(getattr(found, name), json[name], f"{path}.{name}")
    elif isinstance(found, dict):
        assert list(found) == list(json), path
        for key in found:
            assert_same(found[key], json[key], f"{path}[{key}]")
    elif isinstance(found, (list, tuple)):
        assert len(found) == len(json), path
        for i, (one, other) in enumerate(zip(found, json)):
            assert_same(one, other, f"{path}[{i}]")
    elif isinstance(found, fusee.Finding):
        assert (found.rule, found.severity) == (json["rule"], json["severity"]), path
    else:
        assert found == json or (json is None and (found is None or found != found)), path


def test_results_are_those_of_the_program(profiles):
    profile = str(profiles / "pnrvsa.toml")
    assert_same(fusee.budget(profile, draws=200, wanted_percent=3.0), result_of("budget", profile, "--draws", "200", "--wanted", "3"), "budget")
    csv = str(profiles / "examples/break_away.csv")
    assert_same(fusee.identify(csv), result_of("identify", csv)["identification"], "identification")
    for sheet in ("coupon.csv", "k_pe_inspection.csv"):
        sheet = str(profiles / "examples" / sheet)
        assert_same(fusee.calibrate(sheet, profile), result_of("calibrate", sheet, "--profile", profile), "calibration")


def test_one_direction_has_two_readings(profiles, tmp_path):
    rows = (profiles / "examples/break_away.csv").read_text().splitlines()
    (tmp_path / "one_way.csv").write_text("\n".join(row for row in rows if "backdrive" not in row))
    found = fusee.identify(tmp_path / "one_way.csv")
    assert found.law is None and found.one_way[0].to_measure.direction == "backdrive"
    assert found.one_way[0].if_torque_right.mu > 0.0 and found.one_way[0].if_no_friction.torque_scale < 1.0


def test_calibrate_writes_a_profile(profiles, tmp_path):
    fusee.calibrate(profiles / "examples/coupon.csv", profiles / "pnrvsa.toml", write=tmp_path / "calibrated.toml")
    assert "[compensation]" in fusee.Profile(tmp_path / "calibrated.toml").toml
    with pytest.raises(fusee.InvalidInput, match="profile of the coupons"):
        fusee.calibrate(profiles / "examples/coupon.csv", write=tmp_path / "other.toml")


def test_springs_fit_the_profile(profiles):
    profile = fusee.Profile(profiles / "pnrvsa.toml")
    found = fusee.springs(profile, most=2)
    assert [spring.name for spring in found["k_se"].wound] == result_of("springs", str(profiles / "pnrvsa.toml"), "--most", "2")["parts"][0]["wound"]
    changed = profile.with_values(found["k_se"].wound[0].values)
    assert changed["k_se.spring.wire_mm"] > 0.0 and found["k_pe"].tried >= len(found["k_pe"].wound) and not found["k_pe"].bought


def test_pictures_and_models_are_files(profiles, tmp_path):
    fusee.render(profiles / "pnrvsa.toml", tmp_path / "band.svg", "dead-band")
    assert (tmp_path / "band.svg").read_text(encoding="utf-8").startswith("<svg")
    with pytest.raises(fusee.InvalidInput, match="dead-band"):
        fusee.render(profiles / "pnrvsa.toml", tmp_path / "x.svg", "dead_bnd")
    fusee.write_mjcf(profiles / "pnrvsa.toml", tmp_path / "model")
    assert {path.name for path in (tmp_path / "model").iterdir()} >= {"joint.xml", "laws.json", "joint_twin.py"}


def test_a_query_gives_columns(tmp_path):
    with sqlite3.connect(tmp_path / "index.sqlite") as index:  # with the tables of an index of `fusee batch`
        index.execute("CREATE TABLE designs (number INTEGER PRIMARY KEY, name TEXT NOT NULL, mass_g REAL)")
        index.execute("CREATE TABLE columns (name TEXT PRIMARY KEY, meaning TEXT NOT NULL)")
        index.executemany("INSERT INTO designs VALUES (?, ?, ?)", [(1, "a", 12.5), (2, "b", None)])
    table = fusee.query(tmp_path, "SELECT name, mass_g FROM designs ORDER BY name")
    assert list(table) == ["name", "mass_g"] and table["name"].tolist() == ["a", "b"]
    np.testing.assert_array_equal(table["mass_g"], [12.5, np.nan])
    with pytest.raises(fusee.InvalidInput, match="did you mean mass_g"):
        fusee.query(tmp_path, "SELECT mas_g FROM designs")
    with pytest.raises(fusee.IoError):
        fusee.query(tmp_path / "none", "SELECT 1")


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda p: fusee.simulate(p, levels="5"), "fusee.simulate: levels is '5' (str); it must be an integer"),
        (lambda p: fusee.make(p, vai="cgal"), "fusee.make: there is no argument vai; did you mean via?"),
        (lambda p: fusee.make(), "fusee.make: the argument profile is missing"),
        (lambda p: fusee.make(p, "out", "cgal"), "fusee.make: 3 arguments without a name, at most 2 are taken; give via, force, progress by name"),
        (lambda p: fusee.Profile(p).with_values(3), "Profile.with_values: values is 3 (int); it must be a dictionary"),
        (lambda p: fusee.Profile(3), "Profile: path is 3 (int); it must be a path"),
        (lambda p: fusee.Case.from_arrays("x", {}), "Case.from_arrays: the argument experiments is missing: a dictionary"),
    ],
)
def test_wrong_types_are_told_in_words(profiles, call, message):
    with pytest.raises(TypeError) as caught:
        call(str(profiles / "pnrvsa.toml"))
    assert str(caught.value) == message


def test_docstrings_speak_python():
    cpp = re.compile(r"\bk[A-Z][a-z]\w+|\bsrc/|\bread_(case|profile)\b|\bconst\b|check_law|std::|@\w+|several InvalidInput|reentrant|Raises as|C\+\+|\b(?:false|true):|O\(n|\w+\(\) ")
    names = [name for name in fusee.__all__ if not name.startswith("_")]
    texts = {name: inspect.getdoc(getattr(fusee, name)) or "" for name in names}
    for name in names:
        if inspect.isclass(getattr(fusee, name)):
            members = {inner: value for inner, value in vars(getattr(fusee, name)).items() if not inner.startswith("_") or inner == "__init__"}
            texts |= {f"{name}.{inner}": inspect.getdoc(value) or "" for inner, value in members.items()}
    for name, text in texts.items():
        words = text.partition("\n\n")[2] if " -> " in text.partition("\n")[0] else text  # without pybind11's signature
        assert not cpp.search(words), f"{name}: {cpp.search(words)}"


def test_messages_name_arguments_and_no_options_of_the_command_line(profiles, tmp_path):
    sheet, picture = tmp_path / "t.csv", tmp_path / "law.svg"
    sheet.write_text("Motor,Last\n1,2\n")
    picture.write_text("kept")
    with pytest.raises(fusee.InvalidInput, match=r"columns=\['side=Last', 'direction=Motor'") as caught:
        fusee.identify(sheet)
    assert "--" not in str(caught.value) and "columns=[" in caught.value.allowed
    with pytest.raises(fusee.IoError, match="force=True"):
        fusee.render(profiles / "pnrvsa.toml", picture, "law")
    picture.unlink()
    with pytest.raises(fusee.InvalidInput) as caught:
        fusee.render(profiles / "pnrvsa.toml", picture, "laww")
    assert caught.value.key == "view" and "--" not in str(caught.value)


def test_a_law_is_shown(profiles):
    page = fusee.resolve(profiles / "pnrvsa.toml")._repr_html_()
    assert "<b>pnrvsa</b>" in page and "Nm</td>" in page and "loads of the law" in page


def test_the_smallest_part_of_one_spring_can_be_made(profiles):
    profile = fusee.Profile(profiles / "single" / "exo_ankle.toml")
    seen = []
    parts = fusee.smallest_parts(profile, generations=6, progress=seen.append)
    assert list(parts) == seen[: len(parts)] or set(parts) <= set(seen)
    found = [part for part in parts.values() if part.profile is not None]
    assert found and all(part.figures["found"] for part in found)
    assert fusee.check(found[0].profile).processes[0].ok
    with pytest.raises(fusee.InvalidInput, match="fusee.smallest_parts"):
        fusee.design(profile)
    with pytest.raises(fusee.InvalidInput, match="fusee.design"):
        fusee.smallest_parts(fusee.Profile(profiles / "pnrvsa.toml"))
