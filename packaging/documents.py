"""The documents as they are installed: python3 documents.py SOURCES FOLDER HEADERS

Copies README, docs, styles, examples and what else links lead to into FOLDER. HEADERS is where the public headers are, seen
from there. Links to what is not installed become plain text."""

import os
import pathlib
import re
import shutil
import sys

FILES = ["README.md", "CHANGELOG.md", "SECURITY.md", "LICENSE"]
FOLDERS = ["docs", "styles", "examples", "farm"]
LINK = re.compile(r"(!?)\[((?:`[^`]*`|!\[[^]]*\]\([^)]*\)|[^]])*)\]\(([^)\s]+)\)")


def main(sources, target, headers):
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    for name in FILES:
        shutil.copy(sources / name, target / name)
    for name in FOLDERS:
        shutil.copytree(sources / name, target / name, ignore=shutil.ignore_patterns("reference"))
    for page in target.rglob("*.md"):
        page.write_text(LINK.sub(lambda link: installed(link, page, target, headers), page.read_text()))


def installed(link, page, root, headers):
    """A link as it is where `page` is installed."""
    mark, text, place = link.groups()
    name, hash_, anchor = place.partition("#")
    if "://" in place or not name:
        return link[0]
    seen_from_root = os.path.normpath(page.parent.relative_to(root) / name)
    if (root / seen_from_root).exists():
        return link[0]
    public = "host/include/lineatlas"
    if seen_from_root.startswith(public):
        up = os.path.relpath(root, page.parent)
        place = os.path.normpath(os.path.join(up, headers, seen_from_root[len(public):].lstrip("/")))
        return f"{mark}[{text}]({place}{hash_}{anchor})"
    return text


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3])
