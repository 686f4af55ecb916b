#!/usr/bin/env python3
"""The software bill of materials, CycloneDX 1.5, as on the system where it runs: packaging/sbom.json.

sbom.py PROGRAM          prints it: the Debian packages of packages.txt and the npm parts of the pages, and the package of each shared library that
                         the program loads, at its start or when it needs one of its own (../lib/fusee/*.so: STEP, pictures, Pareto fronts), each
                         with its version and its licence
sbom.py --check PROGRAM [FILE...]  exit code 1 unless packaging/sbom.json names the same parts, each with a version, and the packages of these
                         further FILEs, such as libraries that a run has loaded. A version may be another one, and so may the BLAS
"""
import json
import pathlib
import re
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent
USES = {"tools": "build", "libraries": "program", "make": "program", "diagnose": "program", "whole": "program", "tests": "test", "python": "python", "site": "site", "mujoco": "companion", "siconos": "companion"}
LICENCE = "GPL-3.0-or-later"  # of fusee: LICENSE
BLAS = re.compile("lib(atlas3|blas3|lapack3|openblas0|blis4|mkl)")  # which one is loaded, Debian's alternatives choose
PAGES = ("three", "three-mesh-bvh", "uplot")  # bundled into the pages; the others only build the bundle


def packages():
    """(name, use) of each line of packages.txt but those of the site and of the companions, which are in no package."""
    use = ""
    for line in (SOURCE / "packages.txt").read_text().splitlines():
        if line.startswith("#"):
            if heading := re.match(r"# ([a-z_]+):", line):
                use = USES.get(heading.group(1), "called")
        elif line.strip() and use not in ("site", "companion"):
            yield line.strip(), use


def licences():
    """Licence of each library by docs/licences.md: the first two cells of its table and the module's sentence."""
    text = (SOURCE / "docs/licences.md").read_text()
    rows = dict(re.findall(r"(?m)^\| `([^`]+)`[^|]*\| ([^|]+?) \|", text))
    rows.update({name: licence for name, licence in re.findall(r"`([a-z0-9-]+)` \(([A-Za-z]+-[0-9A-Za-z.-]+)", text)})
    return rows


def stated_licence(package):
    """Licences that Debian's copyright file of a package names, where a program can read it."""
    try:
        text = pathlib.Path(f"/usr/share/doc/{package}/copyright").read_text(errors="replace")
    except OSError:
        return None
    names = sorted(set(re.findall(r"(?m)^License: *(\S.*?) *$", text)))
    return " and ".join(names) if names and len(names) <= 12 else f"/usr/share/doc/{package}/copyright"


def component(name, purl, licence, use, version):
    item = {"type": "application" if use in ("called", "build") else "library", "name": name, "version": version,
            "purl": purl + (f"@{version}" if version and "@" not in purl else "")}
    if licence:
        item["licenses"] = [{"license": {"name": licence}}]
    item["scope"] = "required" if use in ("program", "python", "pages", "loaded") else "excluded"
    item["properties"] = [{"name": "fusee:use", "value": use}]
    return item


def query(*words):
    return subprocess.run(["dpkg-query", *words], capture_output=True, text=True).stdout


def versions(names):
    lines = query("-W", "-f=${Package} ${Version}\n", *names).splitlines()
    found = dict(line.split(" ", 1) for line in lines if " " in line.strip())
    for name in set(names) - found.keys():  # a program of another origin is installed: Debian's version
        policy = subprocess.run(["apt-cache", "policy", name], capture_output=True, text=True).stdout
        found |= {name: version for version in re.findall(r"Candidate: (\S+)", policy)}
    return found


def libraries(program):
    """The shared libraries of the program, and of those of its own that it loads when it needs them."""
    program = pathlib.Path(program).resolve()
    files = set()
    for loader in (program, *sorted((program.parent.parent / "lib/fusee").glob("*.so"))):
        lines = subprocess.run(["ldd", loader], capture_output=True, text=True, check=True).stdout
        files |= set(re.findall(r"(?:=> |^\s)(/\S+)", lines, re.M))
    return files


def loaded(files):
    """The packages of these files."""
    real = {str(pathlib.Path(file).resolve()) for file in files}
    paths = real | {re.sub("^/usr", "", path) for path in real} | set(map(str, files))
    return sorted({line.split(":")[0] for line in query("-S", *paths).splitlines()})


def sbom(program):
    licence = licences()
    used = [*packages(), *((name, "loaded") for name in loaded(libraries(program)))]
    version = versions([name for name, _ in used])
    items = [component(name, f"pkg:deb/debian/{name}", licence.get(name) or stated_licence(name), use, version.get(name)) for name, use in used]
    lock = json.loads((SOURCE / "web/package-lock.json").read_text())["packages"]
    for name in sorted(lock[""]["devDependencies"]):
        part = lock[f"node_modules/{name}"]
        items.append(component(name, f"pkg:npm/{name}@{part['version']}", part.get("license"), "pages" if name in PAGES else "build",
                               part["version"]))
    version = re.search(r"project\(fusee VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
    return {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
            "metadata": {"component": {"type": "application", "name": "fusee", "version": version,
                                       "licenses": [{"license": {"id": LICENCE}}]}}, "components": items}


def check(program, files):
    """What is wrong with the committed one."""
    committed, now = json.loads((SOURCE / "packaging/sbom.json").read_text()), sbom(program)
    parts = [{(p["name"], p["properties"][0]["value"]) for p in one["components"] if not BLAS.match(p["name"])} for one in (committed, now)]
    wrong = [f"{name} ({use}) is missing" for name, use in sorted(parts[1] - parts[0])]
    wrong += [f"{name} ({use}) is no part any more" for name, use in sorted(parts[0] - parts[1])]
    wrong += ["fusee has another licence"] if committed["metadata"] != now["metadata"] else []
    wrong += [f"{p['name']} has no version" for p in committed["components"] if not p.get("version")]
    wrong += [f"{p['name']} has no licence" for p in committed["components"] if p["scope"] == "required" and "licenses" not in p]
    names = {p["name"] for p in committed["components"]}
    return wrong + [f"{name}, which a run loads, is missing" for name in loaded(files) if name not in names and not BLAS.match(name)]


def main():
    words = sys.argv[1:]
    if len(words) == 1 and not words[0].startswith("-"):
        print(json.dumps(sbom(words[0]), indent=1))
    elif len(words) >= 2 and words[0] == "--check":
        wrong = check(words[1], words[2:])
        print("\n".join(wrong))
        sys.exit(1 if wrong else 0)
    else:
        sys.exit("usage: sbom.py PROGRAM\n       sbom.py --check PROGRAM [FILE...]")


main()
