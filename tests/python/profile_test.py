"""Profiles: keys, changes, and the errors of C++ as exceptions."""

import fusee
import numpy as np
import pytest


def test_keys_are_in_the_unit_of_their_name(profiles):
    profile = fusee.Profile(profiles / "pnrvsa.toml")
    assert profile.name == "pnrvsa" and profile.file == profiles / "pnrvsa.toml"
    assert profile["rig.gear_friction"] == 0.28
    assert profile["law.kind"] == "stiction_compensating"
    assert profile["process.build_mm"] == [200.0, 200.0, 200.0]
    assert "k_se.spring.rate_Nm_per_rad" in fusee.keys()
    assert "pnrvsa" in repr(profile)


def test_changes_keep_comments_and_take_numpy(profiles):
    profile = fusee.Profile(profiles / "pnrvsa.toml")
    changed = profile.with_values({"cable.diameter_mm": np.float64(1.0), "cable.construction": "fibre", "process.build_mm": np.array([300.0, 250.0, 200.0])})
    assert changed["cable.diameter_mm"] == 1.0 and changed["process.build_mm"] == [300.0, 250.0, 200.0]
    assert profile["cable.diameter_mm"] != 1.0, "the old one is as it was"
    assert changed.sha256 != profile.sha256
    assert changed.toml.count("#") == profile.toml.count("#")
    assert "# diameter_mm was" in profile.with_values({"cable.diameter_mm": 1.0}, why="a try").toml


def test_written_profiles_are_the_same(profiles, tmp_path):
    table = fusee.Profile(profiles / "measured_table.toml")
    (tmp_path / "other").mkdir()
    moved = table.write(tmp_path / "other" / "again.toml")
    assert fusee.resolve(moved).curve.tau.tolist() == fusee.resolve(table).curve.tau.tolist()
    with pytest.raises(fusee.IoError):
        table.write(tmp_path / "other" / "again.toml")
    table.write(tmp_path / "other" / "again.toml", force=True)


def test_invalid_input_is_a_value_error_with_its_place(profiles):
    profile = fusee.Profile(profiles / "pnrvsa.toml")
    with pytest.raises(fusee.InvalidInput) as caught:
        profile.with_values({"rig.gear_friction": -3.0})
    error = caught.value
    assert isinstance(error, ValueError)
    assert error.key == "rig.gear_friction" and error.file == str(profiles / "pnrvsa.toml")
    assert error.line == 1 + profile.toml.splitlines().index(next(l for l in profile.toml.splitlines() if l.startswith("gear_friction")))
    assert "-3" in error.value and error.allowed and error.all == (error,)
    assert "gear_friction" in str(error)


def test_all_mistakes_of_a_reading_are_reported(profiles):
    text = (profiles / "pnrvsa.toml").read_text()
    with pytest.raises(fusee.InvalidInput) as caught:
        fusee.Profile.parse(text.replace("gear_friction =", "gear_frictoin =").replace("diameter_mm = 0.8", "diameter_mm = -1"), profiles / "x.toml")
    assert len(caught.value.all) >= 2
    assert all(isinstance(one, fusee.InvalidInput) and one.line for one in caught.value.all[:2])


@pytest.mark.parametrize("values", [{"rig.gear_fricton": 0.1}, {"rig": 1.0}, {"rig.gear_friction": None}, {"rig.gear_friction": float("nan")}])
def test_wrong_keys_and_values_are_refused(profiles, values):
    with pytest.raises(fusee.InvalidInput):
        fusee.Profile(profiles / "pnrvsa.toml").with_values(values)


def test_a_key_without_meaning_is_a_key_error(profiles):
    with pytest.raises(KeyError):
        fusee.Profile(profiles / "pnrvsa.toml")["law.file"]
    with pytest.raises(fusee.InvalidInput):
        fusee.Profile(profiles / "pnrvsa.toml")["law.fiel"]
    with pytest.raises(KeyError, match=r"rig is a table; one of its keys is rig\."):
        fusee.Profile(profiles / "pnrvsa.toml")["rig"]


def test_a_missing_file_is_an_os_error(tmp_path):
    with pytest.raises(fusee.IoError) as caught:
        fusee.Profile(tmp_path / "none.toml")
    assert isinstance(caught.value, OSError) and "none.toml" in str(caught.value)
