"""docs/words.md: no word has two meanings, and what a word is called in the sources is there."""

import re
import subprocess
import unittest

from documents import ROOT

WORDS = (ROOT / "docs/words.md").read_text()
ROWS = [[cell.strip() for cell in line.strip("|").split("|")]
        for line in WORDS.splitlines() if line.startswith("| ") and not line.startswith("| word ")]
FOLDERS = ["", "host/", "kernels/", "bench/", "glpasses/"]


def is_file(name):
    return any(list(ROOT.glob(folder + name)) for folder in FOLDERS)


def is_in_sources(name):
    word = re.split(r"::", name)[-1].replace("*", "")
    return subprocess.run(["grep", "-rqw" if not name.endswith("*") else "-rq", word, "host", "kernels", "bench",
                           "glpasses"], cwd=ROOT, check=False).returncode == 0


class Words(unittest.TestCase):
    def test_no_word_stands_twice(self):
        words = [row[0] for row in ROWS]
        self.assertGreater(len(words), 70)
        self.assertEqual([], sorted({word for word in words if words.count(word) > 1}))

    def test_what_words_are_called_in_the_sources_is_there(self):
        for row in ROWS:
            for name in re.findall(r"`([^`]+)`", row[2]):
                with self.subTest(word=row[0], name=name):
                    self.assertTrue(is_file(name) if "/" in name else is_in_sources(name))


if __name__ == "__main__":
    unittest.main()
