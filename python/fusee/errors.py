"""What the functions of fusee raise. A design that cannot be made raises nothing: it is a result with findings."""

import re

_PLACE = re.compile(r"^(?P<file>.*?):(?P<line>\d+):(?P<column>\d+): (?P<key>.*)$", re.DOTALL)


class InvalidInput(ValueError):
    """A value is wrong: names its field, the value found and what is allowed; several values of one reading are in `all`."""

    def __init__(self, message: str, field: str = "", value: str = "", allowed: str = "", all: "tuple[InvalidInput, ...]" = ()) -> None:
        super().__init__(message)
        self.field: str = field
        """The place of the value: "rig.gear_friction", or with its file "a.toml:3:1: rig.gear_friction"."""
        self.value: str = value
        self.allowed: str = allowed
        self.all: tuple[InvalidInput, ...] = tuple(all) or (self,)
        place = _PLACE.match(field)
        self.key: str = place["key"] if place else field
        self.file: str | None = place["file"] if place else None
        self.line: int | None = int(place["line"]) if place else None
        self.column: int | None = int(place["column"]) if place else None


class Refusal(Exception):
    """Raised by the function of a Model: it cannot simulate these parameters. The hypothesis is out, and the diagnosis goes on."""


class IoError(OSError):
    """A file could not be read, written or understood."""
