#!/usr/bin/env python3
"""unity_names_test.py SOURCE_FOLDER: the functions in the anonymous namespaces of a module have different names.

A unity build compiles several sources of a module as one: a call then also sees the functions of the other sources, and takes the one whose
parameters fit better. Two functions called in_full did that, and a search left out candidates without a warning of the compiler.
"""
import collections
import pathlib
import re
import sys

FUNCTION = re.compile(
    r"^(?!return\b|using\b|namespace\b|if\b|else\b|for\b|while\b|switch\b|case\b|struct\b|class\b|enum\b|static_assert|friend\b|throw\b)"
    r"(?:template\b.*> )?[A-Za-z\[][\w:<>,&*\[\] ]*?[ &*](\w+)\(")


def functions(path):
    """Names of the functions in the anonymous namespaces of a source, defined at the start of a line."""
    inside, found = False, set()
    for line in path.read_text().splitlines():
        if line == "namespace {":
            inside = True
        elif line == "}  // namespace":
            inside = False
        elif inside and not line.endswith(";"):
            match = FUNCTION.match(line)
            if match and f"::{match.group(1)}(" not in line:
                found.add(match.group(1))
    return found


def main(sources):
    count, twice = 0, []
    for module in sorted(folder for folder in sources.iterdir() if folder.is_dir()):
        files = collections.defaultdict(list)
        for path in sorted(module.rglob("*.cpp")):
            for name in functions(path):
                files[name].append(path.name)
        count += len(files)
        twice += [f"src/{module.name}: {name} is in {' and in '.join(in_files)}" for name, in_files in sorted(files.items()) if len(in_files) > 1]
    if count < 1000:
        sys.exit(f"{count} functions found: fewer than the sources have")
    if twice:
        sys.exit("a unity build mixes these functions up; rename one of each:\n" + "\n".join(twice))
    print(f"{count} functions, each name once in its module")


main(pathlib.Path(sys.argv[1]))
