"""What the functions of fusee raise. A design that cannot be made raises nothing: it is a result with findings."""

import re

_PLACE = re.compile(r"^(?P<file>.*?):(?P<line>\d+):(?P<column>\d+): (?P<key>.*)$", re.DOTALL)

_COLUMNS = re.compile(r"--columns ('[^']*'|[^\s;)]+)(?: --columns ('[^']*'|[^\s;)]+))*")
_OPTION = re.compile(r"--(?:(force|resume)|(columns|keep|most|seconds|view))\b")


def _in_python(text: str) -> str:
    """An option of the command line that a message names, as an argument: --force is force=True."""

    def list_of(found: "re.Match[str]") -> str:
        return "columns=[" + ", ".join(repr(word.strip(" '")) for word in found[0].split("--columns ")[1:]) + "]"

    return _OPTION.sub(lambda found: found[1] + "=True" if found[1] else found[2], _COLUMNS.sub(list_of, text))


class InvalidInput(ValueError):
    """A value is wrong: names its field, the value found and what is allowed; several values of one reading are in `all`."""

    def __init__(self, message: str, field: str = "", value: str = "", allowed: str = "", all: "tuple[InvalidInput, ...]" = ()) -> None:
        super().__init__(_in_python(message))
        field = _in_python(field)
        self.field: str = field
        """The place of the value: "rig.gear_friction", or with its file "a.toml:3:1: rig.gear_friction"."""
        self.value: str = value
        self.allowed: str = _in_python(allowed)
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

    def __init__(self, *words: "str | int") -> None:
        super().__init__(*(_in_python(word) if isinstance(word, str) else word for word in words))
