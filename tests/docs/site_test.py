#!/usr/bin/env python3
"""The site's hook puts the tables of rules, keys and JSON files into their pages. site_test.py PROGRAM SOURCE"""
import os
import pathlib
import sys
import types

program, source = sys.argv[1], pathlib.Path(sys.argv[2])
sys.dont_write_bytecode = True
sys.path.insert(0, str(source / "cmake/site"))
os.environ["FUSEE_PROGRAM"] = program
import hooks  # noqa: E402


def shown(name):
    page = types.SimpleNamespace(file=types.SimpleNamespace(src_path=name))
    return hooks.on_page_markdown((source / "docs" / name).read_text(encoding="utf-8"), page, None, None)


SHOWN = {"README.md": ["(samples/diagnosis.html)"], "rules.md": ["| `cable.bend_ratio` |", "| `joint.winding` |", "| `mesh.wall` |"],
         "profile.md": ["| `diameter_mm` | 0.05 to 20 mm | required |", "### `[[limits]]`"],
         "report.md": ["| `verdict` |", "| `read_back` |", "| `binding` |"],
         "simulation.md": ["| `levels` |", "| `exact_rad` |", "| `dead_band` |"],
         "gap.md": ["| `traces` |", "| `unknown_term` |"],
         "part-file.md": ["| `target[].arm_mm` |", "| `guide.kind` |", "| `objects` |"],
         "guides/close-the-loop.md": ["| `off_with_new_cams` |"], "guides/identify-friction.md": ["| `one_way` |"],
         "guides/fix.md": ["| `conflicts` |"], "guides/design-springs.md": ["| `own_dead_band` |"],
         "guides/check.md": ["| `processes` |"], "guides/paper.md": ["| `figure_8` |"], "benchmark.md": ["| `shrink` |"]}
for name, rows in SHOWN.items():
    page = shown(name)
    for row in rows:
        assert row in page, f"{name} lacks {row}"
    assert "<!-- site:" not in page, f"{name}: a mark is left"
marked = {str(path.relative_to(source / "docs")) for path in (source / "docs").rglob("*.md") if "<!-- site:" in path.read_text(encoding="utf-8")}
assert marked == set(SHOWN), f"{sorted(marked)}: add the page to this test"
link = hooks.on_page_markdown("[a test](../tests/x.cpp)", types.SimpleNamespace(file=types.SimpleNamespace(src_path="a.md")), None, None)
assert link == "a test (`tests/x.cpp`)", link
for written, wanted in [("a:\n- b\n  c\n- d", "a:\n\n- b\n    c\n- d"), ("1. a\n\n   ```sh\n   b\n   ```", "1. a\n\n\n        b\n"),
                        ("```text\na:\n- b\n```", "```text\na:\n- b\n```")]:
    assert hooks.lists(written) == wanted, hooks.lists(written)
