"""mkdocs hook: links from a page to files outside docs/ become the file's name, because the site holds the pages only."""
import os
import re

LINK = re.compile(r"\[([^\]]*)\]\(([^)#\s]+)(#[^)\s]*)?\)")


def on_page_markdown(markdown, page, config, files):
    folder = os.path.dirname(page.file.src_path)

    def inside(match):
        text, link = match.group(1), match.group(2)
        target = os.path.normpath(os.path.join(folder, link))
        if "://" in link or not target.startswith(".."):
            return match.group(0)
        repository_path = os.path.normpath(os.path.join("docs", target))
        return text if repository_path in text else f"{text} (`{repository_path}`)"

    return LINK.sub(inside, markdown)
