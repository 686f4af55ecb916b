"""Says in words which argument of a call is wrong: pybind11 lists the signatures that it knows instead."""

from __future__ import annotations

import difflib
import functools
import inspect
import numbers
import os
import re
from typing import Any, Callable

_HEAD = re.compile(r"^(?:\w+)?\((?P<arguments>.*)\) -> ", re.DOTALL)
_KINDS: dict[str, tuple[type, ...]] = {
    "int": (numbers.Integral,),
    "float": (numbers.Real,),
    "bool": (bool,),
    "str": (str,),
    "dict": (dict,),
    "os.PathLike": (str, os.PathLike),
}


def _split(text: str) -> list[str]:
    """The arguments between commas that are in no bracket and no text."""
    parts, depth, quoted = [""], 0, False
    for letter in text:
        quoted ^= letter == "'"
        depth += (letter in "[({") - (letter in "])}")
        if letter == "," and depth == 0 and not quoted:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


def _signature(doc: str) -> list[tuple[str, str, bool, bool]]:
    """Name, type, has a default, by name only."""
    match = _HEAD.match(doc.strip().splitlines()[0]) if doc.strip() else None
    found, by_name = [], False
    for part in _split(match["arguments"]) if match else []:
        if part == "*":
            by_name = True
            continue
        name, _, rest = part.partition(":")
        kind, equals, _ = rest.partition(" = ")
        found.append((name.strip(), kind.strip(), bool(equals), by_name))
    return found


def _fits(kind: str, value: Any) -> bool:
    if optional := re.fullmatch(r"Optional\[(.*)\]", kind):
        return value is None or _fits(optional[1], value)
    if kind == "bool":
        return isinstance(value, bool)
    if kind in ("int", "float") and isinstance(value, bool):
        return False
    if kind.startswith(("List[", "Tuple[")):
        return not isinstance(value, (str, bytes)) and hasattr(value, "__iter__")
    if kind.startswith("numpy.ndarray"):
        return not isinstance(value, (str, bytes)) and (hasattr(value, "__iter__") or isinstance(value, numbers.Real))
    return kind not in _KINDS or isinstance(value, _KINDS[kind])


def _called(kind: str) -> str:
    if optional := re.fullmatch(r"Optional\[(.*)\]", kind):
        return f"{_called(optional[1])} or None"
    if kind.startswith(("List[", "Tuple[")):
        return "a list"
    if kind.startswith("numpy.ndarray"):
        return "numbers"
    words = {"int": "an integer", "float": "a number", "bool": "True or False", "str": "a text", "dict": "a dictionary", "os.PathLike": "a path"}
    return words.get(kind, kind.rpartition(".")[2])


def _fault(name: str, signature: list[tuple[str, str, bool, bool]], args: tuple[Any, ...], kwargs: dict[str, Any]) -> str | None:
    """What is wrong with the arguments, or None if it is not known."""
    known = [one[0] for one in signature]
    places = [one for one in signature if not one[3]]
    for word in kwargs:
        if word not in known:
            near = difflib.get_close_matches(word, known, 1)
            return f"{name}: there is no argument {word}" + (f"; did you mean {near[0]}?" if near else f"; it takes {', '.join(known)}")
    if len(args) > len(places):
        late = [one[0] for one in signature if one[3]]
        more = f"; give {', '.join(late)} by name" if late else ""
        return f"{name}: {len(args)} arguments without a name, at most {len(places)} are taken{more}"
    given = dict(zip(known, args)) | kwargs
    for argument, kind, has_default, _ in signature:
        if argument not in given:
            if not has_default:
                return f"{name}: the argument {argument} is missing: {_called(kind)}" if kind != "object" else f"{name}: the argument {argument} is missing"
        elif not _fits(kind, given[argument]):
            return f"{name}: {argument} is {given[argument]!r:.80} ({type(given[argument]).__name__}); it must be {_called(kind)}"
    return None


def in_words(name: str, function: Callable[..., Any], method: bool) -> Callable[..., Any]:
    """The function with TypeErrors in words; other exceptions are as they were."""
    signature = _signature(function.__doc__ or "")

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        try:
            return function(*args, **kwargs)
        except TypeError as error:
            if "incompatible" not in str(error):
                raise
            fault = _fault(name, signature[1:], args[1:], kwargs) if method else _fault(name, signature, args, kwargs)
            raise TypeError(fault or f"{name}: the arguments are of other types: see help({name})") from None

    return call


def speak(module: Any, names: list[str]) -> dict[str, Callable[..., Any]]:
    """The module's functions among the names, in words; the methods of its classes are replaced in place."""
    functions = {}
    for name in names:
        member = getattr(module, name)
        if inspect.isbuiltin(member):
            functions[name] = in_words(f"fusee.{name}", member, False)
        if not inspect.isclass(member):
            continue
        for inner, value in list(vars(member).items()):
            if isinstance(value, staticmethod):
                setattr(member, inner, staticmethod(in_words(f"{name}.{inner}", value.__func__, False)))
            elif inner == "__init__" and "__init__(self" in (value.__doc__ or ""):
                setattr(member, inner, in_words(name, value, True))
            elif callable(value) and not inner.startswith("_"):
                setattr(member, inner, in_words(f"{name}.{inner}", value, True))
    return functions
