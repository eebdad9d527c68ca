# SPDX-License-Identifier: BSD-3-Clause
"""site_pages.py FOLDER: copies the pages of the site into FOLDER and turns links between files of the project into links of the site.

A page of docs keeps its path below docs; some files of other folders are pages, too. Any other file that a page links to, such as an
example, becomes a page that shows its text.
"""

import os
import pathlib
import re
import shutil
import sys

PAGES = {
    "CHANGELOG.md": "changes.md",
    "CONTRIBUTING.md": "contributing.md",
    "SECURITY.md": "security.md",
    "README.md": "index.md",  # only as the target of links
    "comparisons/README.md": "measuring.md",
    "comparisons/RESULTS.md": "results.md",
}
LANGUAGES = {".cpp": "cpp", ".hpp": "cpp", ".py": "python", ".sh": "sh", ".bash": "sh", ".txt": "text", "": "text"}
LINK = re.compile(r"(\]\()([^)\s]+)(\))")


def page_of(path):
    """The path on the site of a file of the project."""
    if path in PAGES:
        return PAGES[path]
    if path.startswith("docs/"):
        return path.removeprefix("docs/")
    return "source/" + path + ".md"


def links(text, path, shown):
    """The text of the page at `path`, with its links turned. Adds files that are to be shown to `shown`."""
    here = os.path.dirname(page_of(path)) or "."

    def turned(match):
        target, _, anchor = match[2].partition("#")
        if not target or ":" in target:
            return match[0]
        target = os.path.normpath(os.path.join(os.path.dirname(path), target))
        page = page_of(target)
        if page.startswith("source/"):
            shown.add(target)
        return match[1] + os.path.relpath(page, here) + ("#" + anchor if anchor else "") + match[3]

    parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)  # code is left alone
    return "".join(part if part.startswith("```") else LINK.sub(turned, part) for part in parts)


def main(folder):
    out = pathlib.Path(folder)
    shutil.rmtree(out, ignore_errors=True)
    shown = set()
    sources = [str(p) for p in pathlib.Path("docs").rglob("*.md")] + [p for p in PAGES if p != "README.md"]
    for path in sources:
        place = out / page_of(path)
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(links(pathlib.Path(path).read_text(), path, shown))
    for path in sorted(shown):
        place = out / page_of(path)
        place.parent.mkdir(parents=True, exist_ok=True)
        language = LANGUAGES.get(pathlib.Path(path).suffix, "text")
        place.write_text(f"# {path}\n\n```{language}\n{pathlib.Path(path).read_text()}```\n")
    for path in pathlib.Path("docs").rglob("*"):
        if path.suffix in (".svg", ".png", ".css"):
            place = out / page_of(str(path))
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, place)


main(sys.argv[1])
