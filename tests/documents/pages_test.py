"""What docs/style.md asks of every page, as far as a program can tell."""

import re
import unittest

from documents import PAGES, ROOT, without_blocks

# What a page of today does not say: how things came to be so is in the commits.
HISTORY = re.compile(r"\b(since then|another run|minutes before|in the meantime|as it was before|at first it)\b", re.IGNORECASE)

# What measures and explains must stay short enough to be read.
LONG = ["benchmarks", "quality", "reliability", "decisions/*"]


def faults(text):
    found = []
    fences = [line for line in text.splitlines() if "```" in line]
    if len(fences) % 2 or any(not re.fullmatch(r" *```\w*", line) for line in fences):
        found.append("a fence of a block of code is not on a line of its own, or not closed")
    found += [f"history: {phrase}" for phrase in HISTORY.findall(re.sub(r"`[^`]*`", "", without_blocks(text)))]
    for table in re.findall(r"(?:^\|.*\n)+", text, re.MULTILINE):
        rows = [re.sub(r"`[^`]*`|\\\|", "", row).count("|") for row in table.splitlines()]
        if len(set(rows)) > 1:
            found.append(f"a table with rows of different lengths: {table.splitlines()[0]}")
    return found


class Pages(unittest.TestCase):
    def test_pages_are_well_made(self):
        for page in PAGES:
            with self.subTest(page=page.name):
                self.assertEqual([], faults(page.read_text()))

    def test_what_is_not_is_found(self):
        self.assertEqual(1, len(faults("a ```sh ls``` b\n")))
        self.assertEqual(1, len(faults("```sh\nls\n")))
        self.assertEqual(["history: Since then"], faults("Since then it is faster.\n"))
        self.assertEqual(1, len(faults("| a | b |\n|---|---|\n| 1 |\n")))
        self.assertEqual([], faults("| a | `b|c` |\n|---|---|\n| 1 | 2 |\n\n```sh\nls | wc\n```\n"))

    def test_the_reference_names_every_public_header(self):
        page = (ROOT / "docs/reference/main.md").read_text()
        headers = {f"lineatlas/{header.name}" for header in (ROOT / "host/include/lineatlas").iterdir()}
        self.assertEqual(headers, set(re.findall(r"lineatlas/\w+\.hpp", page)))

    def test_long_pages_are_not_longer(self):
        pages = [page for name in LONG for page in (ROOT / "docs").glob(f"{name}.md")]
        self.assertGreater(len(pages), 10)
        self.assertLess(sum(len(page.read_text().splitlines()) for page in pages), 3000)


if __name__ == "__main__":
    unittest.main()
