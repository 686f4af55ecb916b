"""Stub and module are equal, every name has a docstring, and the types hold where mypy is installed."""

import inspect
import os
import pathlib
import subprocess
import sys

import fusee
import pytest

SOURCE = pathlib.Path(os.environ["FUSEE_SOURCE_DIR"])


def test_the_stub_is_that_of_the_module():
    folder = pathlib.Path(fusee.__file__).parent.parent
    command = [sys.executable, SOURCE / "python/tools/stubs.py", folder, SOURCE / "python/fusee/_fusee.pyi"]
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout + "\nupdate: cmake --build build --target fusee_python_stubs"


def test_everything_has_a_docstring():
    for name in fusee.__all__:
        if name == "__version__":
            continue
        member = getattr(fusee, name)
        assert inspect.getdoc(member), name
        if inspect.isclass(member) and member.__module__ == "fusee._fusee":
            for inner, value in vars(member).items():
                if not inner.startswith("_"):
                    assert inspect.getdoc(value), f"{name}.{inner}"


def test_the_types_hold(tmp_path):
    mypy = pytest.importorskip("mypy.api", reason="mypy is not installed")
    examples = [str(path) for path in sorted((SOURCE / "python/examples").glob("*.py"))]
    environment = str(SOURCE / "python")
    os.environ["MYPYPATH"] = environment
    out, errors, code = mypy.run(["--strict", "--ignore-missing-imports", "--cache-dir", str(tmp_path), "-p", "fusee", *[]])
    assert code == 0, out + errors
    out, errors, code = mypy.run(["--ignore-missing-imports", "--cache-dir", str(tmp_path), *examples])
    assert code == 0, out + errors
