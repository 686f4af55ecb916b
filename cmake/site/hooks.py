"""mkdocs hooks: a page as the site shows it.

- `<!-- site: fusee ARGS -->` becomes what the program prints: tables of rules and keys are in no page, so that they cannot be out of date.
- `<!-- site: NAME of json-schema/files.json -->` becomes the table of that definition's keys.
- Links to files outside docs/ become the file's name, because the site holds the pages only.
"""
import json
import os
import pathlib
import re
import shlex
import subprocess

LINK = re.compile(r"\[([^\]]*)\]\(([^)#\s]+)(#[^)\s]*)?\)")
FILES = pathlib.Path(__file__).parents[2] / "docs/json-schema/files.json"
SCHEMA = re.compile(r"^<!-- site: (.*) of json-schema/files\.json -->$", re.M)
PRINTED = re.compile(r"^<!-- site: fusee (.*) -->$", re.M)


def printed(markdown, program):
    """@param program: the built fusee, FUSEE_PROGRAM of the environment (cmake/FuseeSite.cmake)"""
    return PRINTED.sub(lambda mark: subprocess.run([program, *shlex.split(mark.group(1))], check=True, capture_output=True, text=True).stdout,
                       markdown)


def key_rows(definition, prefix=""):
    """"guide.kind", "target[].arm_mm" and their meanings; members with a definition of their own stand in its table."""
    for key, member in definition["properties"].items():
        if "description" in member:
            yield prefix + key, member["description"]
        for inner, mark in ((member, "."), (member.get("items", {}), "[].")):
            if "properties" in inner:
                yield from key_rows(inner, prefix + key + mark)


def key_table(mark):
    definition = json.loads(FILES.read_text(encoding="utf-8"))["definitions"][mark.group(1)]
    rows = "".join(f"| `{key}` | {meaning} |\n" for key, meaning in key_rows(definition))
    return f"{definition['description']}\n\n| key | holds |\n|---|---|\n{rows}"


def on_page_markdown(markdown, page, config, files):
    folder = os.path.dirname(page.file.src_path)

    def inside(match):
        text, link = match.group(1), match.group(2)
        target = os.path.normpath(os.path.join(folder, link))
        if "://" in link or not target.startswith(".."):
            return match.group(0)
        repository_path = os.path.normpath(os.path.join("docs", target))
        return text if repository_path in text else f"{text} (`{repository_path}`)"

    return SCHEMA.sub(key_table, printed(LINK.sub(inside, markdown), os.environ.get("FUSEE_PROGRAM", "fusee")))
