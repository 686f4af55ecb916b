import os
import pathlib
import shutil

import pytest

SOURCE = pathlib.Path(os.environ["FUSEE_SOURCE_DIR"])


@pytest.fixture
def profiles(tmp_path, monkeypatch):
    """A copy of the shipped profiles, in the working folder."""
    shutil.copytree(SOURCE / "profiles", tmp_path / "profiles")
    monkeypatch.chdir(tmp_path)
    return tmp_path / "profiles"
