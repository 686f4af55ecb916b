"""Values of JSON as the fields of a dataclass."""

from __future__ import annotations

import dataclasses
import math
import types
import typing
from typing import Any


def as_field(kind: Any, value: Any) -> Any:
    """A value of JSON as the type of a field: null of a number is NaN."""
    origin, of = typing.get_origin(kind), typing.get_args(kind)
    if origin in (types.UnionType, typing.Union):
        return None if value is None else as_field(of[0], value)
    if kind is float:
        return math.nan if value is None else float(value)
    if origin is list:
        return [as_field(of[0], one) for one in value]
    if origin is tuple:
        return tuple(as_field(one, part) for one, part in zip(of, value))
    if origin is dict:
        return {key: as_field(of[1], one) for key, one in value.items()}
    if dataclasses.is_dataclass(kind):
        hints = typing.get_type_hints(kind)
        return kind(**{name: as_field(hint, value[name]) for name, hint in hints.items()})
    return value
