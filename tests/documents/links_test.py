"""Every relative link and picture of README and docs leads somewhere, in the checkout and where they are installed."""

import os
import pathlib
import tempfile
import unittest

from documents import PAGES, ROOT, anchors, links

INSTALLED = pathlib.Path(os.environ.get("LINEATLAS_DOCUMENTS", ""))


def broken(page, root):
    """The links of `page` that lead nowhere, or out of `root`."""
    found = []
    for link in links(page.read_text()):
        if "://" in link or link.startswith("mailto:"):
            continue
        name, _, anchor = link.partition("#")
        target = (page.parent / name).resolve() if name else page
        if not target.exists() or root.resolve() not in target.parents:
            found.append(f"{page.relative_to(root)}: {link}: there is no such file")
        elif anchor and target.suffix == ".md" and anchor not in anchors(target.read_text()):
            found.append(f"{page.relative_to(root)}: {link}: there is no such heading")
    return found


class Links(unittest.TestCase):
    def test_in_the_checkout(self):
        self.assertGreater(len(PAGES), 25)
        self.assertEqual([], [fault for page in PAGES for fault in broken(page, ROOT)])

    def test_where_documents_are_installed(self):
        pages = sorted(INSTALLED.rglob("*.md"))
        self.assertGreater(len(pages), 25)
        prefix = INSTALLED.parents[2]
        self.assertEqual([], [fault for page in pages for fault in broken(page, prefix)])
        self.assertGreater(sum(len(list(links(page.read_text()))) for page in pages), 150)

    def test_broken_links_are_found(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "a.md").write_text("# One\n\n[a](b.md) [b](#one) [c](#two) ![d](d.png) `[e](e.md)` <img src=\"f.png\">\n"
                                         "```sh\n[g](g.md)\n```\n[h](../h.md) [i](https://example.org)\n")
            self.assertEqual(["b.md", "#two", "d.png", "../h.md", "f.png"],
                             [fault.split(": ")[1] for fault in broken(folder / "a.md", folder)])

    def test_every_page_is_in_the_index(self):
        for folder in (ROOT / "docs", ROOT / "docs/decisions"):
            index = folder / "README.md"
            listed = {(folder / link).resolve() for link in links(index.read_text()) if "://" not in link}
            self.assertEqual(set(), {page.resolve() for page in folder.glob("*.md")} - {index} - listed)


if __name__ == "__main__":
    unittest.main()
