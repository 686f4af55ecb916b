#!/usr/bin/env python3
"""Runs every command with --json and checks what it prints against docs/json-schema/fusee.json, and the files against files.json.
json_schema_test.py SOURCE PROGRAM; exit code 77 where python3-jsonschema is missing."""
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

SOURCE, PROGRAM = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
P = SOURCE + "/profiles/"
SCHEMA = json.load(open(SOURCE + "/docs/json-schema/fusee.json"))
jsonschema.Draft7Validator.check_schema(SCHEMA)
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)

FILES = json.load(open(SOURCE + "/docs/json-schema/files.json"))
jsonschema.Draft7Validator.check_schema(FILES)

# Each line with the exit codes that it may have. Later lines use files of earlier ones.
LINES = [
    ("make %sfirst_prototype.toml" % P, 0),
    ("make bad.toml", 2),
    ("make missing.toml", 2),
    ("make refused.toml", 1),
    ("make --via openscd x.toml", 2),
    ("make --bar x.toml", 2),
    ("mkae x.toml", 2),
    ("", 2),
    ("check %spnrvsa.toml" % P, 0),
    ("check out/first_prototype/k_pe.stl --process fdm", (0, 1)),
    ("fix %spnrvsa.toml --out fixed.toml" % P, 0),
    ("batch quick.toml --dry-run", 0),
    ("batch quick.toml --name b", 0),
    ("batch quick.toml --name b --merge", 0),
    ("query out/b 'SELECT name, mass_g FROM designs'", 0),
    ("query out/b 'SELECT nothing FROM designs'", 2),
    ("design %spnrvsa.toml --method algorithm_1 --generations 3 --population 8" % P, (0, 1)),
    ("springs %spnrvsa.toml --out springs.toml --most 1" % P, (0, 1)),
    ("budget %spnrvsa.toml --draws 20" % P, 0),
    ("init bad.toml --yes", 2),
    ("watch missing.toml", 2),
    ("render %spnrvsa.toml --view law --out law.svg" % P, 0),
    ("coupons %spnrvsa.toml" % P, 0),
    ("calibrate %sexamples/coupon.csv" % P, 0),
    ("simulate %spnrvsa.toml --levels 3 --at 1,0.9,0 --out sim" % P, 0),
    ("case-template %spnrvsa.toml --out case" % P, 0),
    ("identify %sexamples/break_away.csv" % P, 0),
    ("blind make --seed 1 --cases 1 --out blind", 0),
    ("diagnose case --out diagnosis", 0),
    ("predict blind/case000 --inputs blind/case000/heldout --out predicted", 0),
    ("blind score blind --out score", 0),
    ("paper --profiles missing", 2),
    ("explain cable.bend_ratio law.kind gear.coulomb law cable dead-band", 0),
    ("explain bend_rato", 2),
    ("keys law", 0),
    ("rules cable", 0),
    ("completion bash", 0),
    ("man", 0),
]


def commands():
    """Every command that the help lists, "blind make" included, and the hidden ones."""
    found = {"completion", "man"}
    for prefix in ("", "blind"):
        text = subprocess.run([PROGRAM] + prefix.split() + ["--help"], capture_output=True, text=True, check=True).stdout
        for section in re.findall(r"^(?:Make a part|Test a joint|Look up|Subcommands):\n((?:  .*\n)+)", text, re.M):
            found |= {(prefix + " " + name).strip() for name in re.findall(r"^  ([a-z][a-z-]*) ", section, re.M)}
    return found - {"blind"}


def check(line, codes):
    """The command of one line, as its object names it."""
    ended = subprocess.run("'%s' --json %s" % (PROGRAM, line), shell=True, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    allowed = codes if isinstance(codes, tuple) else (codes,)
    assert ended.returncode in allowed, "%s: exit code %d\n%s%s" % (line, ended.returncode, ended.stdout[:2000], ended.stderr)
    answer = json.loads(ended.stdout)
    faults = ["%s: %s" % ("/".join(map(str, e.path)), e.message[:300]) for e in VALIDATOR.iter_errors(answer)]
    keys = "result of " + str(answer["command"])
    if keys in FILES["definitions"] and ended.returncode < 2:
        validator = jsonschema.Draft7Validator({**FILES, "$ref": "#/definitions/" + keys.replace(" ", "%20")})
        faults += [e.message[-300:] for e in validator.iter_errors(answer["result"])]
    assert not faults, "%s\n%s" % (line, "\n".join(faults[:5]))
    assert answer["exit_code"] == ended.returncode, line
    if ended.returncode > 1:
        assert ended.stderr.strip(), line + ": an error is a line on standard error, too"
    return answer["command"]


def lay_measured_parts():
    """Of an example, into the empty case: break-away and spring pull alone, which are quick to diagnose."""
    for rows in ("breakaway.csv", "spring_pull.csv"):
        shutil.copy(P + "examples/bench_monday/" + rows, "case")
    text = open("case/case.toml").read()
    with open("case/case.toml", "w") as file:
        file.write(re.sub(r"(?m)^(dead_band|joint_stiffness|cocontraction|log) *= .*", "", text))


def check_files():
    """Every key of the files that the lines wrote has its meaning in files.json."""
    patterns = {"report.json": ["out/*/report.json"], "simulation.json": ["out/*/simulation.json", "sim/*/simulation.json"],
                "diagnosis.json": ["diagnosis/diagnosis.json"], "PART.json": ["out/first_prototype/k_??.json", "out/first_prototype/k_??_mirrored.json"],
                "plate.json": ["out/*/plate.json"], "design.json": ["out/*-design/design.json"],
                "identification.json": ["out/identify-*/identification.json"], "score.json": ["score/score.json"]}
    for name, found in patterns.items():
        validator = jsonschema.Draft7Validator({**FILES, "$ref": "#/definitions/" + name})
        paths = [path for pattern in found for path in glob.glob(pattern)]
        assert paths, "no %s was written" % name
        for path in paths:
            faults = ["%s: %s" % ("/".join(map(str, e.path)), e.message[-300:]) for e in validator.iter_errors(json.load(open(path)))]
            assert not faults, "%s: docs/json-schema/files.json\n%s" % (path, "\n".join(faults[:5]))
            assert not validator.is_valid({"no_such_key": 1}), "%s accepts anything" % name


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with open("bad.toml", "w") as file:
            file.write("name = 3\n")
        profile = open(P + "pnrvsa.toml").read()
        with open("quick.toml", "w") as file:
            file.write(re.sub(r"(?m)^formats = .*", 'formats = ["stl"]', profile))
        with open("refused.toml", "w") as file:
            file.write(re.sub(r"start_torque_Nm = [0-9.]+", "start_torque_Nm = 0.2", profile, count=1))
        seen = set()
        for line, codes in LINES:
            if line.startswith("blind score"):
                open("blind/case000/case.toml", "w").close()  # a case that cannot be read is a miss, found at once; a diagnosis takes 40 s
            if line.startswith("diagnose case"):
                lay_measured_parts()
            seen.add(check(line, codes))
        check_files()
    missing = commands() - seen
    assert not missing, "commands that no line runs: %s" % sorted(missing)
    broken = {"fusee": "1", "command": "keys", "exit_code": 0, "verdict": "done", "error": None, "result": [{"key": 3}]}
    assert not VALIDATOR.is_valid(broken), "the schema accepts anything"
    print("%d lines of %d commands agree with the schema" % (len(LINES), len(seen)))


main()
