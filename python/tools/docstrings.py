"""Docstrings of the Python module, from the comments of the C++ headers.

docstrings.py INCLUDE_FOLDER OUTPUT SOURCE...

Writes a table of the comments that the sources ask for by doc("module::Type::member"). Ends with 1 if a header has no such comment.
"""

import pathlib
import re
import sys

NAMESPACE = re.compile(r"^namespace fusee::(\w+(?:::\w+)*) \{")
SCOPE = re.compile(r"^(?:struct|class|enum class) (\w+)\b[^;]*\{")
ATTRIBUTE = re.compile(r"\[\[\w+\]\]\s*")
FUNCTION = re.compile(r"(\w+)\(")
MEMBERS = re.compile(r"(\w+)\s*(?:=[^,;]*|\{[^}]*\})?(?=[,;])")

WORDS = [
    (re.compile(r"@throws\s+"), "Raises "),
    (re.compile(r"@returns?\s+"), "Returns "),
    (re.compile(r"@param\s+(\w+)"), r"\1:"),
    (re.compile(r"@pre\s+"), "Needs: "),
    (re.compile(r"\bk(NoFigure|Unknown)\b"), "NaN"),
    (re.compile(r"\b(false|true)\b(?=:)"), lambda match: match[1].capitalize()),
    (re.compile(r"\bInvalidInputs\b"), "InvalidInput"),
    (re.compile(r"\b(?:\w+::)+(\w+)"), r"\1"),
]


def as_text(lines):
    """One paragraph a comment, in Python's words."""
    text = " ".join(line for line in lines if line)
    for pattern, words in WORDS:
        text = pattern.sub(words, text)
    return re.sub(r"\s+", " ", text).strip()


def names_of(code):
    """The names that a line of C++ declares."""
    code = ATTRIBUTE.sub("", code)
    scope = SCOPE.match(code) or re.match(r"^(?:struct|class|enum class) (\w+)", code)
    if scope:
        return [scope.group(1)]
    function = FUNCTION.search(code)
    if function and "=" not in code[: function.start()]:
        return [function.group(1)]
    enumerator = re.match(r"^(k[A-Z]\w*)\s*,?$", code)
    if enumerator:
        return [enumerator.group(1)]
    return MEMBERS.findall(re.sub(r"<[^;]*?>", "", code))


class Header:
    """The comments of one header by qualified name."""

    def __init__(self):
        self.comments = {}
        self.module = ""
        self.scopes = []  # (name, depth of its braces)
        self.depth = 0
        self.above = []
        self.last = []

    def keep(self, names, lines):
        path = "::".join([self.module] + [name for name, _ in self.scopes])
        for name in names:
            self.comments.setdefault(f"{path}::{name}", []).extend(lines)
        self.last = [f"{path}::{name}" for name in names]

    def take(self, line):
        line = line.strip()
        if line.startswith("///<"):  # the comment of the line above goes on
            for name in self.last:
                self.comments[name].append(line[4:].strip())
            return
        if line.startswith("///"):
            self.above.append(line[3:].strip())
            return
        code, _, comment = line.partition("///<")
        code = code.split("//")[0].strip()
        if match := NAMESPACE.match(code):
            self.module, self.depth, self.above = match.group(1), 1, []
            return
        if not code:
            self.above = []
            return
        lines = self.above + ([comment.strip()] if comment else [])
        if lines:
            self.keep(names_of(code), lines)
        self.above = []
        if scope := SCOPE.match(ATTRIBUTE.sub("", code)):
            self.scopes.append((scope.group(1), self.depth))
        self.depth += code.count("{") - code.count("}")
        while self.scopes and self.depth <= self.scopes[-1][1]:
            self.scopes.pop()


def comments_of(folder):
    found = {}
    for path in sorted(folder.rglob("*.h")):
        header = Header()
        for line in path.read_text(encoding="utf-8").splitlines():
            header.take(line)
        for name, lines in header.comments.items():
            found.setdefault(name, as_text(lines))
    return found


def main(include, output, *sources):
    found = comments_of(pathlib.Path(include))
    wanted = set()
    for source in sources:
        wanted.update(re.findall(r'\bdoc\("([\w:]+)"\)', pathlib.Path(source).read_text(encoding="utf-8")))
    missing = sorted(name for name in wanted if not found.get(name))
    for name in missing:
        print(f"docstrings.py: no header has a comment for {name}", file=sys.stderr)
    rows = "".join(f'    {{"{name}", R"doc({found[name]})doc"}},\n' for name in sorted(wanted - set(missing)))
    text = f"// Made by python/tools/docstrings.py from the headers.\nconstexpr Docstring kDocstrings[] = {{\n{rows}}};\n"
    pathlib.Path(output).write_text(text, encoding="utf-8")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
