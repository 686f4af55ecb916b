"""The examples and the blocks of docs/guides/python.md run, and print what they are said to print."""

import ast
import contextlib
import io
import json
import os
import pathlib
import re
import runpy
import sys

import pytest

SOURCE = pathlib.Path(os.environ["FUSEE_SOURCE_DIR"])


def printed_by(example, profile, monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", [example, str(profile)])
    runpy.run_path(str(SOURCE / "python/examples" / example), run_name="__main__")
    return capsys.readouterr().out


def test_sweep(profiles, monkeypatch, capsys, tmp_path):
    text = printed_by("sweep.py", profiles / "pnrvsa.toml", monkeypatch, capsys)
    widths = [float(number) for number in re.findall(r"dead-band ([\d.]+) deg", text)]
    assert len(widths) == 3 and widths[-1] == pytest.approx(20.4, abs=0.05)
    assert "can be made" in text.splitlines()[2]
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        assert "matplotlib is not installed" in text
    else:
        assert (tmp_path / "sweep.png").stat().st_size > 10_000


def test_function_law(profiles, monkeypatch, capsys, tmp_path):
    text = printed_by("function_law.py", profiles / "measured_table.toml", monkeypatch, capsys)
    assert float(re.search(r"relative ([\d.e-]+)", text)[1]) <= 1e-4
    assert "k_se: arms" in text and "k_pe: arms" in text and "error:" not in text and "warning:" not in text
    assert (tmp_path / "function_law.toml").exists() and (tmp_path / "function_law.csv").exists()


def test_diagnosis(profiles, monkeypatch, capsys):
    text = printed_by("diagnosis.py", profiles / "pnrvsa.toml", monkeypatch, capsys)
    assert "identified" in text and "gear.coulomb on agonist" in text


def test_the_guide(profiles):
    blocks = re.findall(r"^```(python|output)\n(.*?)^```$", (SOURCE / "docs/guides/python.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert len(blocks) >= 6
    names, output = {}, ""
    for kind, text in blocks:
        if kind == "python":
            assert output == "", "a block that prints has its output below"
            stream = io.StringIO()
            with contextlib.redirect_stdout(stream):
                exec(compile(text, "docs/guides/python.md", "exec"), names)
            output = stream.getvalue()
        else:
            assert output == text
            output = ""
    assert output == ""


def shown(source, names):
    """What a cell of a notebook shows: the value of its last line, if that is an expression."""
    body = ast.parse(source).body
    last = ast.Expression(body.pop().value) if isinstance(body[-1], ast.Expr) else None
    exec(compile(ast.Module(body, []), "cell", "exec"), names)
    return last and eval(compile(last, "cell", "eval"), names)


def test_the_notebook(profiles, monkeypatch, capsys, tmp_path):
    notebook = json.loads((SOURCE / "python/examples/first_part.ipynb").read_text(encoding="utf-8"))
    cells = ["".join(cell["source"]).replace("profiles/", f"{profiles}/") for cell in notebook["cells"] if cell["cell_type"] == "code"]
    monkeypatch.chdir(tmp_path)
    names = {}
    values = [shown(cell, names) for cell in cells]
    assert [len(value._repr_html_()) > 100 for value in values if hasattr(value, "_repr_html_")] == [True] * 3
    assert values[2] and all(rule and suggestion for rule, suggestion in values[2])
    assert "-0.490 to 0.981 Nm" in capsys.readouterr().out
    assert (tmp_path / "cam.stl").stat().st_size > 10_000
