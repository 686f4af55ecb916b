"""The type stub of the C++ module, from the signatures that pybind11 writes into its docstrings.

stubs.py FOLDER STUB [update]

Compares the stub with the module of FOLDER, a folder for sys.path; `update` writes it. Ends with 1 if they differ.
"""

import difflib
import inspect
import pathlib
import re
import sys
import textwrap

HEAD = '''# Made by python/tools/stubs.py from the module: cmake --build build --target fusee_python_stubs
import os
from collections.abc import Sequence
from typing import Any, Callable, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from fusee.results import Absorption, Against, Budget, Calibration, Gap, Identification, PartSprings, SmallestPart

'''

TYPES = [
    (re.compile(r"\b(?:fusee\.)?_fusee\."), ""),
    (re.compile(r"numpy\.ndarray\[numpy\.float64\]"), "NDArray[np.float64]"),
    (re.compile(r"numpy\.ndarray\[numpy\.uint32\]"), "NDArray[np.uint32]"),
    (re.compile(r"numpy\.ndarray\[bool\]"), "NDArray[np.bool_]"),
    (re.compile(r"Annotated\[List\[float\], FixedSize\((\d)\)\]"), r"list[float]"),
    (re.compile(r"List\[float\[\d\]\]"), "list[float]"),
    (re.compile(r"\bOptional\[([^\[\]]*(?:\[[^\[\]]*\])?)\]"), r"\1 | None"),
    (re.compile(r"\bList\["), "list["),
    (re.compile(r"\bDict\["), "dict["),
    (re.compile(r"\bTuple\["), "tuple["),
    (re.compile(r"\bos\.PathLike\b|\bPath\b|pathlib\.Path"), "os.PathLike[str]"),
    (re.compile(r"\b(?:fusee|std)::[\w:<>, ]+"), "Any"),
]

# What C++ takes as any object.
ARGUMENTS = {
    "profile: object = None": "profile: Profile | str | os.PathLike[str] | None = None",
    "profile: object": "profile: Profile | str | os.PathLike[str]",
    "case: object": "case: Case | str | os.PathLike[str]",
    "progress: object": "progress: Callable[..., object] | None",
    "against: object = None": "against: Case | Model | str | os.PathLike[str] | None = None",
    "simulate: function": "simulate: Callable[..., object]",
    "-> object": "-> Any",
    ": dict": ": dict[str, Any]",
    "-> dict": "-> dict[str, Any]",
    "-> list:": "-> list[Any]:",
}

# A docstring that is nothing but the words that a text can be.
QUOTED = r'"[^"]+"'
WORDS = re.compile(rf"{QUOTED}(?:(?:, | or ){QUOTED})+")

# Results that the module gives as an object or a dictionary, or a word of a set whose docstring says more.
RESULTS = {
    "Finding.bound": 'Literal["at most", "at least"]',
    "Diagnosis.absorption": "Absorption | None",
    "Diagnosis.against": "Against | None",
    "Diagnosis.gap": "Gap",
    "Simulation.release_path": "dict[str, dict[str, NDArray[np.float64]]]",
    "Case.experiments": "dict[str, dict[str, NDArray[Any]]]",
    "CaseTemplate.experiments": "dict[str, dict[str, NDArray[Any]]]",
    "predict": "dict[str, dict[str, NDArray[Any]]]",
    "query": "dict[str, NDArray[Any]]",
    "smallest_parts": "dict[str, SmallestPart]",
    "springs": "dict[str, PartSprings]",
    "budget": "Budget",
    "identify": "Identification",
    "calibrate": "Calibration",
    "Profile.__getitem__": "bool | int | float | str | list[Any]",
}


def typed(text, argument):
    for pattern, name in TYPES:
        text = pattern.sub(name, text)
    if argument:
        text = text.replace("list[", "Sequence[")
        text = re.sub(r"NDArray\[np\.float64\]", "ArrayLike", text)
        text = re.sub(r"(?<!\| )os\.PathLike\[str\]", "str | os.PathLike[str]", text)
    return text


def signature_of(doc, name, path):
    """The arguments, the result and the text of a docstring of pybind11. path: "Case.experiments"."""
    head, _, text = doc.partition("\n")
    match = re.match(rf"(?:{re.escape(name)})?(\(.*\)) -> (.*)$", head)
    if not match:
        raise ValueError(f"{name}: no signature in {head!r}")
    arguments, result = typed(match[1], True), typed(match[2], False)
    line = f"{arguments} -> {result}:"
    for old, new in ARGUMENTS.items():
        line = re.sub(re.escape(old) + r"(?![\w\[])", new, line)
    line = re.sub(r"\(self: \w+", "(self", line)
    line = re.sub(r"= '([^']*)'", r'= "\1"', line)
    if name == "diagnose":
        line = line.replace("case: Case |", "case: Case | Model |")
    if name == "predict":  # needs no measurements
        line = line.replace("case: Case |", "case: Case | CaseTemplate |")
    if path in RESULTS:
        line = re.sub(r"-> .*:$", f"-> {RESULTS[path]}:", line)
    return line, text.strip()


def body(text, indent):
    pad = " " * indent
    if not text:
        return f"{pad}...\n"
    lines = textwrap.wrap(text.replace("\\", "\\\\"), 120)
    if len(lines) == 1 and not lines[0].endswith('"'):
        return f'{pad}"""{lines[0]}"""\n'
    return f'{pad}"""\n' + "".join(f"{pad}{line}\n" for line in lines) + f'{pad}"""\n'


def property_stub(cls, name, member):
    line, _ = signature_of(member.fget.__doc__.lstrip(), "", f"{cls}.{name}")
    if WORDS.fullmatch((member.__doc__ or "").strip()) and line.endswith("-> str:"):
        line = f"{line[:-4]}Literal[{', '.join(re.findall(QUOTED, member.__doc__))}]:"
    return f"    @property\n    def {name}{re.sub(r'^.[^)]*.', '(self)', line)}\n" + body((member.__doc__ or "").strip(), 8)


def method_stub(cls, name, member, static):
    line, text = signature_of(member.__doc__.lstrip(), name, f"{cls}.{name}")
    if not static:
        line = re.sub(r"^\(self: [^,)]*", "(self", line)
    return ("    @staticmethod\n" if static else "") + f"    def {name}{line}\n" + body(text, 8)


SPECIAL = ("__init__", "__getitem__", "__len__", "__repr__", "__str__", "_repr_html_")


def class_stub(cls):
    text = f"class {cls.__name__}:\n" + body((cls.__doc__ or "").strip(), 4)
    for name, member in vars(cls).items():
        if name.startswith("_") and name not in SPECIAL:
            continue
        if name == "__init__" and "__init__(self" not in (member.__doc__ or ""):
            continue  # nobody makes one
        if isinstance(member, property):
            text += property_stub(cls.__name__, name, member)
        else:
            text += method_stub(cls.__name__, name, getattr(cls, name), isinstance(member, staticmethod))
    return text + "\n"


def stub_of(module):
    text = HEAD
    members = vars(module)
    for name, member in members.items():
        if inspect.isclass(member):
            text += class_stub(member)
    for name, member in members.items():
        if inspect.isbuiltin(member):
            line, words = signature_of(member.__doc__.lstrip(), name, name)
            text += f"def {name}{line}\n" + body(words, 4) + "\n"
    return text + "__version__: str\n"


def main(folder, stub, action=""):
    sys.path.insert(0, folder)
    import fusee._fusee as module

    path, text = pathlib.Path(stub), stub_of(module)
    if action == "update":
        path.write_text(text, encoding="utf-8")
        return 0
    old = path.read_text(encoding="utf-8")
    sys.stdout.writelines(difflib.unified_diff(old.splitlines(True), text.splitlines(True), str(path), "the module"))
    return 0 if old == text else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
