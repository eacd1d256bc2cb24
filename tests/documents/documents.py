"""What the tests of documents share: where they lie, and their links, blocks and names."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]

#: All that people read, from the root of the checkout.
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md"), *(ROOT / "docs/decisions").glob("*.md"),
                *(ROOT / ".github").rglob("*.md")])

FENCE = re.compile(r"^( *)```(\w*)\n(.*?)^\1```$", re.MULTILINE | re.DOTALL)


def without_blocks(text):
    """A page's text without its blocks of code."""
    return FENCE.sub("", text)


def blocks(text, language):
    """The blocks of code of one language, without the indentation of the list that they stand in."""
    for indent, name, block in FENCE.findall(text):
        if name == language:
            yield re.sub(f"^{indent}", "", block, flags=re.MULTILINE)


def anchors(text):
    """What `#...` of a link to this page may be, made of its headings as forges make it."""
    found = set()
    for heading in re.findall(r"^#+ +(.*)$", without_blocks(text), re.MULTILINE):
        plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").lower()
        found.add(re.sub(r"[^\w\- ]", "", plain).strip().replace(" ", "-"))
    return found


def links(text):
    """The targets of all links and pictures of a page, also of those written as HTML."""
    plain = re.sub(r"`[^`\n]*`", lambda code: "`" + "x" * (len(code[0]) - 2) + "`", without_blocks(text))
    for target in re.findall(r"\]\(([^)\s]+)\)", plain) + re.findall(r'(?:src|href)="([^"]+)"', plain):
        yield target


def section(text, title):
    """What stands below the heading `title`, up to the next one of its level or above."""
    found = re.search(rf"^(#+) {re.escape(title)}\n(.*?)(?=^#{{1,6}} |\Z)", text, re.MULTILINE | re.DOTALL)
    if found is None:
        raise KeyError(title)
    level = len(found[1])
    rest = text[found.start(2):]
    end = re.search(rf"^#{{1,{level}}} ", rest, re.MULTILINE)
    return rest[: end.start()] if end else rest
