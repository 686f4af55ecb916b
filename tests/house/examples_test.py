#!/usr/bin/env python3
"""The examples of the public headers (@code) compile. examples_test.py SOURCE COMPILER FLAG..."""
import pathlib
import re
import subprocess
import sys

source, compiler, flags = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
CODE = re.compile(r"/// @code\n(.*?)/// @endcode\n", re.S)
GIVEN = {"part": "const solid::Part&", "spring": "const spring::BaseSpring&", "cable": "const checks::Cable&", "process": "const checks::Process&",
         "provenance": "const core::Provenance&", "design": "const pipeline::ResolvedDesign&", "p": "const profile::Profile&"}
MORE = ["core/file.h", "core/provenance.h", "core/units.h", "formats/format.h", "gap_case/case.h", "pipeline/design.h", "pipeline/simulate.h",
        "profile/profile.h", "readback/readback.h"]

bodies, headers = [], set(MORE)
for header in sorted((source / "include/fusee").rglob("*.h")):
    for code in CODE.findall(header.read_text(encoding="utf-8")):
        lines = [line[4:] for line in code.splitlines()]
        headers.add(str(header.relative_to(source / "include/fusee")))
        text = "\n".join(lines)
        made = set(re.findall(r"\b(\w+)(?= = |\{|\()", text)) & set(GIVEN)
        arguments = [f"{kind} {name}" for name, kind in GIVEN.items() if re.search(rf"(?<![\w.:]){name}\b(?!\()", text) and name not in made
                     and not re.search(rf"[&>\w] {name} [=:]", text)]
        bodies.append(f"// {header.name}\nAny example_{len(bodies)}({', '.join(arguments)}) {{\n{text}\nreturn {{}};\n}}\n")
assert len(bodies) >= 10, "the examples are not found"
unit = "#include <iostream>\n" + "".join(f'#include "fusee/{name}"\n' for name in sorted(headers))
unit += "using namespace fusee;\nstruct Any {\n    Any() = default;\n    template <class T> Any(T&&) {}\n};\n" + "".join(bodies)
ended = subprocess.run([compiler, "-x", "c++", "-std=c++20", "-fsyntax-only", f"-I{source / 'include'}", *flags, "-"], input=unit, text=True)
sys.exit(ended.returncode)
