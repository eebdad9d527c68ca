# SPDX-License-Identifier: BSD-3-Clause
"""links.py [SITE]: checks that all links of the Markdown files lead somewhere and, with SITE, those of the built site. Pages of the site must
load nothing from elsewhere."""

import html.parser
import pathlib
import re
import subprocess
import sys
import urllib.parse

wrong = []


def slug(heading):
    """The anchor of a heading, as GitHub and MkDocs make it from ASCII."""
    return re.sub(r"[\s]+", "-", re.sub(r"[^\w\s-]", "", re.sub(r"[`*]", "", heading)).strip().lower())


def without_code(text):
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S))


def check_sources():
    files = subprocess.run(
        ["git", "-c", "safe.directory=*", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"],
        capture_output=True, text=True, check=True)
    for name in files.stdout.split():
        page = pathlib.Path(name)
        if not page.exists():
            continue
        for target in re.findall(r"\]\(([^)\s]+)\)", without_code(page.read_text())):
            path, _, anchor = target.partition("#")
            if ":" in path or path.startswith("reference/"):  # which Doxygen makes
                continue
            found = page if not path else page.parent / path
            if not found.exists():
                wrong.append(f"{name}: {target} is not there")
            elif anchor and found.suffix == ".md":
                headings = re.findall(r"^#+ (.*)$", found.read_text(), flags=re.M)
                if anchor not in map(slug, headings):
                    wrong.append(f"{name}: {target} names no heading")


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.links, self.ids, self.loads = [], set(), []

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.ids.update(attributes[key] for key in ("id", "name") if attributes.get(key))
        if tag == "a" and attributes.get("href"):
            self.links.append(attributes["href"])
        if attributes.get("src"):
            self.loads.append(attributes["src"])
        if tag == "link" and attributes.get("href") and attributes.get("rel") not in ("canonical", "alternate"):
            self.loads.append(attributes["href"])


def check_site(site):
    pages = {}

    def read(path):
        if path not in pages:
            pages[path] = Page()
            pages[path].feed(path.read_text(errors="replace"))
        return pages[path]

    for path in site.rglob("*.html"):
        if site / "reference" in path.parents or path.name == "404.html":
            continue  # Doxygen checks its own
        page = read(path)
        for target in page.loads:
            if re.match(r"(https?:)?//", target):
                wrong.append(f"{path}: loads {target}")
        for target in page.links + page.loads:
            parts = urllib.parse.urlsplit(target)
            if parts.scheme or parts.netloc:
                continue
            found = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if found.is_dir():
                found = found / "index.html"
            if not found.exists():
                wrong.append(f"{path}: {target} is not there")
            elif parts.fragment and found.suffix == ".html" and site / "reference" not in found.parents:
                if urllib.parse.unquote(parts.fragment) not in read(found).ids and parts.fragment != "__comments":
                    wrong.append(f"{path}: {target} names no place")
    for path in site.rglob("*.css"):
        for target in re.findall(r"url\(([^)]*)\)", path.read_text()):
            if re.match(r"[\"']?(https?:)?//", target):
                wrong.append(f"{path}: loads {target}")
    if not pages:
        wrong.append(f"{site}: has no pages")


check_sources()
if len(sys.argv) > 1:
    check_site(pathlib.Path(sys.argv[1]).resolve())
print("\n".join(wrong) or "all links lead somewhere")
sys.exit(1 if wrong else 0)
