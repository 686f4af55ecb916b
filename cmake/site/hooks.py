"""mkdocs hooks: a page as the site shows it.

- `<!-- site: fusee ARGS -->` becomes what the program prints: tables of rules and keys are in no page, so that they cannot be out of date.
- `<!-- site: NAME of json-schema/files.json -->` becomes the table of that definition's keys.
- `<!-- site: samples -->` becomes links to the sample pages, which samples.sh made.
- Links to files outside docs/ become the file's name, because the site holds the pages only.
- Lists and code in them stand as mkdocs' Markdown wants them: a blank line before a list, four columns before what belongs to an item.
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
SAMPLES = "<!-- site: samples -->"
ITEM = re.compile(r"(- |1\. )\S")
FENCE = re.compile(r"( *)```")
SAMPLE_PAGES = {"report.html": "the report of a design", "assembly.html": "the joint put together", "simulation.html": "how the joint behaves",
                "diagnosis.html": "the diagnosis of a bench test"}
PRINTED = re.compile(r"^<!-- site: fusee (.*) -->$", re.M)


def printed(markdown, program):
    """@param program: the built fusee, FUSEE_PROGRAM of the environment (cmake/FuseeSite.cmake)"""
    return PRINTED.sub(lambda mark: subprocess.run([program, *shlex.split(mark.group(1))], check=True, capture_output=True, text=True).stdout,
                       markdown)


def sample_links():
    return "Pages that fusee writes: " + ", ".join(f"[{text}](samples/{name})" for name, text in SAMPLE_PAGES.items()) + "."


def on_files(files, config):
    """The sample pages are files of the site. Their folder: FUSEE_SAMPLES of the environment (cmake/FuseeSite.cmake)."""
    from mkdocs.structure.files import File
    for name in SAMPLE_PAGES:
        page = File("samples/" + name, os.environ["FUSEE_SAMPLES"], config["site_dir"], False)
        files.append(page)
    return files


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


def lists(markdown):
    """Python-Markdown knows no list after a line of text, no item's text at two or three columns, and no fence in an item."""
    lines, code = [], None  # code: the column of the fence that is open
    for line in markdown.split("\n"):
        fence = FENCE.match(line)
        if fence:
            code = len(fence[1]) if code is None else None
            line = "" if fence[1] else line
        elif code:
            line = "        " + line[code:]
        elif code is None and ITEM.match(line) and lines and lines[-1].strip() and not re.match(r"    |- |\d+\. ", lines[-1]):
            lines.append("")
        elif code is None and re.match(r" {2,3}\S", line):
            line = "    " + line.lstrip()
        lines.append(line)
    return "\n".join(lines)


def on_page_markdown(markdown, page, config, files):
    folder = os.path.dirname(page.file.src_path)

    def inside(match):
        text, link = match.group(1), match.group(2)
        target = os.path.normpath(os.path.join(folder, link))
        if "://" in link or not target.startswith(".."):
            return match.group(0)
        repository_path = os.path.normpath(os.path.join("docs", target))
        return text if repository_path in text else f"{text} (`{repository_path}`)"

    markdown = LINK.sub(inside, lists(markdown)).replace(SAMPLES, sample_links())
    return SCHEMA.sub(key_table, printed(markdown, os.environ.get("FUSEE_PROGRAM", "fusee")))
