# SPDX-License-Identifier: BSD-3-Clause
"""prose.py: counts what the rules of the documentation limit: words of a sentence, lines of a page, of the README and of the change log."""

import pathlib
import re
import sys

WORDS_OF_SENTENCE = 30
WORDS_OF_ENTRY = 20  # of the change log
LINES_OF_PAGE = 150
COLUMNS = 100  # of a line of prose, without the targets of its links
LIMITS = {"README.md": (120, 800), "CHANGELOG.md": (100, None), "CONTRIBUTING.md": (50, None)}  # lines and words
BUILDERS = {"docs/design.md", "docs/patches.md", "docs/distributed.md"}  # how it is built: not for users
wrong = []


def blocks(text):
    """Paragraphs, list entries and headings of a page as (line, text), without code, tables and comments."""
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    found, line_of_block, words, is_code = [], 0, [], False
    for number, line in enumerate(text.split("\n") + [""], 1):
        if line.startswith("```"):
            is_code = not is_code
            line = ""
        starts = re.match(r"\s*([-*]|\d+\.) |#+ ", line)
        if is_code or not line.strip() or line.startswith("|") or starts:
            if words:
                found.append((line_of_block, " ".join(words)))
            words = []
        if is_code or not line.strip() or line.startswith("|") or line.startswith("#"):
            continue
        if not words:
            line_of_block = number
        words.append(line.strip())
    return found


def sentences(block):
    text = re.sub(r"\]\([^)]*\)", "]", block)
    text = re.sub(r"`[^`]*`", "code", text)
    return re.split(r"(?<=[.!?])[)*\]]*\s+(?=\S)", text)


def count(sentence):
    return len(re.findall(r"\S*\w\S*", sentence))


def check(path):
    name, text = str(path), path.read_text()
    lines = text.count("\n")
    most, most_words = LIMITS.get(name, (LINES_OF_PAGE, None))
    if lines > most and name not in BUILDERS:
        wrong.append(f"{name}: {lines} lines, at most {most}")
    if most_words and len(text.split()) > most_words:
        wrong.append(f"{name}: {len(text.split())} words, at most {most_words}")
    if name in BUILDERS:
        return
    most = WORDS_OF_ENTRY if name == "CHANGELOG.md" else WORDS_OF_SENTENCE
    for line, block in blocks(text):
        if name == "CHANGELOG.md" and re.match(r"[-*] ", block) and count(block) > WORDS_OF_ENTRY:
            wrong.append(f"{name}:{line}: an entry of {count(block)} words, at most {WORDS_OF_ENTRY}")
        for sentence in sentences(block):
            if count(sentence) > WORDS_OF_SENTENCE:
                wrong.append(f"{name}:{line}: a sentence of {count(sentence)} words: {sentence[:60]}...")
    is_code = False
    for number, line in enumerate(text.split("\n"), 1):
        is_code ^= line.startswith("```")
        if not is_code and not line.startswith("|") and len(re.sub(r"\]\([^)]*\)", "]", line)) > COLUMNS:
            wrong.append(f"{name}:{number}: {len(line)} columns")


for page in sorted(pathlib.Path("docs").rglob("*.md")) + [
        pathlib.Path(name) for name in [*LIMITS, "SECURITY.md", "comparisons/README.md", "comparisons/RESULTS.md"]]:
    check(page)
print("\n".join(wrong) or "all pages are within their limits")
sys.exit(1 if wrong else 0)
