#!/usr/bin/env python3
"""The software bill of materials, CycloneDX 1.5: packaging/sbom.json.

sbom.py            prints the committed form: Debian packages of packages.txt and npm parts, with their licences (docs/licences.md, package-lock.json)
sbom.py --release  the form of a release: with the versions that are installed here, and every shared library that PROGRAM loads
                   sbom.py --release PROGRAM
"""
import json
import pathlib
import re
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent
USES = {"tool chain": "build", "libraries": "program", "tests and benchmarks": "test", "the Python module and its tests": "python",
        "programs": "called"}
PAGES = ("three", "three-mesh-bvh", "uplot")  # bundled into the pages; the others only build the bundle


def packages():
    """(name, use) of each line of packages.txt."""
    use = ""
    for line in (SOURCE / "packages.txt").read_text().splitlines():
        if line.startswith("#"):
            use = next((value for key, value in USES.items() if line[2:].startswith(key)), use)
        elif line.strip():
            yield line.strip(), use


def licences():
    """Licence of each library by docs/licences.md: the first two cells of its table and the module's sentence."""
    text = (SOURCE / "docs/licences.md").read_text()
    rows = dict(re.findall(r"(?m)^\| `([^`]+)`[^|]*\| ([^|]+?) \|", text))
    rows.update({name: licence for name, licence in re.findall(r"`([a-z0-9-]+)` \(([A-Za-z]+-[0-9A-Za-z.-]+)", text)})
    return rows


def component(name, purl, licence, use, version=None):
    item = {"type": "application" if use in ("called", "build") else "library", "name": name}
    if version:
        item["version"] = version
    item["purl"] = purl + (f"@{version}" if version and "@" not in purl else "")
    if licence:
        item["licenses"] = [{"license": {"name": licence}}]
    item["scope"] = "required" if use in ("program", "python", "pages") else "excluded"
    item["properties"] = [{"name": "fusee:use", "value": use}]
    return item


def installed(name):
    found = subprocess.run(["dpkg-query", "-W", "-f=${Version}", name], capture_output=True, text=True)
    return found.stdout or None


def loaded(program):
    """Packages of the shared libraries that the program loads."""
    lines = subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout
    files = sorted(set(re.findall(r"=> (/\S+)", lines)))
    owners = set()
    for file in files:
        for path in (file, str(pathlib.Path(file).resolve()), re.sub("^/usr", "", str(pathlib.Path(file).resolve()))):
            found = subprocess.run(["dpkg-query", "-S", path], capture_output=True, text=True).stdout
            if found:
                owners.add(found.split(":")[0])
                break
    return sorted(owners)


def sbom(program=None):
    licence = licences()
    items = [component(name, f"pkg:deb/debian/{name}", licence.get(name), use, installed(name) if program else None)
             for name, use in packages()]
    lock = json.loads((SOURCE / "web/package-lock.json").read_text())["packages"]
    for name in sorted(lock[""]["devDependencies"]):
        part = lock[f"node_modules/{name}"]
        items.append(component(name, f"pkg:npm/{name}@{part['version']}", part.get("license"), "pages" if name in PAGES else "build",
                               part["version"]))
    if program:
        items += [component(name, f"pkg:deb/debian/{name}", None, "program", installed(name)) for name in loaded(program)]
    version = re.search(r"project\(fusee VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
    return {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
            "metadata": {"component": {"type": "application", "name": "fusee", "version": version}}, "components": items}


def main():
    program = sys.argv[2] if len(sys.argv) == 3 and sys.argv[1] == "--release" else None
    if len(sys.argv) > 1 and not program:
        sys.exit("usage: sbom.py [--release PROGRAM]")
    print(json.dumps(sbom(program), indent=1))


main()
