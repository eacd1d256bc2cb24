"""The check-lists of CONTRIBUTING.md: every file they name is there and knows the list's example; labels and commands exist."""

import os
import re
import subprocess
import unittest

from documents import ROOT, section

PAGE = (ROOT / "CONTRIBUTING.md").read_text()
LISTS = re.split(r"^### ", section(PAGE, "Check-lists"), flags=re.MULTILINE)[1:]
PATH = re.compile(r"`([\w./-]+/[\w./-]+|\w+\.md|\w+\.txt|run)`")


def files(text, example=""):
    return [ROOT / name.replace("NAME", example) for name in PATH.findall(text)]


def spelled(example):
    """The example as C++, files of styles and people write it."""
    return re.compile("(?<![A-Za-z])(?i:" + example.replace("-", "[-_ ]") + ")(?![a-z])")


def knows(path, example):
    if path.is_dir() or spelled(example).search(path.stem):
        return True
    return bool(spelled(example).search(re.sub(r"\.(cpp|cl)\b", "", path.read_text())))


def missing(text):
    """What a check-list names that is not there, or does not know the list's example."""
    example = re.search(r"^Example: `(.*)`$", text, re.MULTILINE)[1]
    found = []
    for item in re.findall(r"^- (.*(?:\n  .*)*)", text, re.MULTILINE):
        for path in files(item.split(":")[0], example):
            if not path.exists():
                found.append(f"{path}: there is none")
            elif not knows(path, example):
                found.append(f"{path}: nothing of {example}")
    return found


class CheckLists(unittest.TestCase):
    def test_each_item_names_a_file_that_knows_the_example(self):
        self.assertEqual(5, len(LISTS))
        for text in LISTS:
            with self.subTest(text.splitlines()[0]):
                self.assertGreater(text.count("\n- "), 4)
                self.assertEqual([], missing(text))

    def test_an_item_that_is_wrong_is_found(self):
        text = "A stage\n\nExample: `temporal`\n\n- `kernels/none.cl`: x.\n- `kernels/scan.cl`: x.\n- `kernels/NAME.cl`: x.\n"
        self.assertEqual([f"{ROOT}/kernels/none.cl: there is none", f"{ROOT}/kernels/scan.cl: nothing of temporal"],
                         missing(text))

    def test_every_file_of_the_page_is_there(self):
        for path in files(re.sub(r"`[\w./-]*NAME[\w./-]*`", "", PAGE)):
            with self.subTest(path=str(path)):
                # Relative to the rooms that the sentence is about, in the list of stages.
                self.assertTrue(path.exists() or "build" in path.parts or list(ROOT.glob(f"host/**/{path.name}")))

    def test_labels_are_those_of_the_tests(self):
        table = re.findall(r"^\| `(\w+)` \|", section(PAGE, "Tests"), re.MULTILINE)
        said = subprocess.run(["ctest", "--test-dir", os.environ["LINEATLAS_BUILD"], "--print-labels"],
                              capture_output=True, text=True, check=True).stdout
        labels = re.findall(r"^  (\w+)$", said, re.MULTILINE)
        self.assertEqual(sorted(labels), sorted(table))

    def test_commands_are_those_of_run(self):
        commands = set(re.findall(r"\./run (\w[\w-]*)", PAGE))
        self.assertGreater(len(commands), 10)
        branches = set(re.findall(r"^(?:help \| )?([a-z-]+)\)", (ROOT / "run").read_text(), re.MULTILINE))
        self.assertEqual(set(), commands - branches - {"help"})


if __name__ == "__main__":
    unittest.main()
