"""The tables of docs/architecture.md: those of host/compute/stages/table_names.hpp, each once; and every one of these has a user."""

import re
import unittest

from documents import ROOT, section

LIST = (ROOT / "host/compute/stages/table_names.hpp").read_text()
PAGE = section((ROOT / "docs/architecture.md").read_text(), "The tables")
SOURCES = [path for room in ("host", "glpasses") for path in (ROOT / room).glob("**/*.[ch]pp")]


def listed():
    return re.findall(r'\{"([\w ]+)", [\w:]+\}', LIST)


def described(page):
    """Names in the first column."""
    return [name for row in re.findall(r"^\| (`.*?) \|", page, re.MULTILINE) for name in re.findall(r"`(.*?)`", row)]


class Tables(unittest.TestCase):
    def test_the_page_describes_those_of_the_list(self):
        self.assertGreater(len(listed()), 100)
        self.assertEqual(sorted(listed()), sorted(described(PAGE)))

    def test_each_is_used(self):
        names = re.findall(r"(\w+)(?:\[\])?\{\s*(?:\"|\{\")", LIST)
        self.assertIn("clipped", names)
        used = {name for path in SOURCES for name in re.findall(r"\btable::(\w+)", path.read_text())}
        self.assertEqual([], [name for name in names if name not in used])


if __name__ == "__main__":
    unittest.main()
