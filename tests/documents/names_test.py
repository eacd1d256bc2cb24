"""What pages name is there: commands of ./run, scripts, tests and files of the sources."""

import pathlib
import re
import shutil
import subprocess
import unittest

from documents import PAGES, ROOT


def checked_out():
    """The files of the checkout; none outside of one, or without git."""
    if shutil.which("git") is None:
        return []
    return subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False).stdout.split()


FILES = checked_out()
FOLDERS = {path.split("/")[0] for path in FILES if "/" in path}
BRANCHES = set(re.findall(r"^(?:help \| )?([a-z-]+)\)", (ROOT / "run").read_text(), re.MULTILINE)) | {"help"}
# Tests are named after their file, with the suite before it where it is not of C++, or by a line of CMake.
NAMES = {prefix + pathlib.Path(path).stem for path in FILES for prefix in ("", "documents_", "python_")}
CMAKE = "".join((ROOT / path).read_text() for path in FILES if path.endswith(("CMakeLists.txt", ".cmake")))


def missing(text):
    """What a page names that is not there."""
    found = [f"./run {name}" for name in re.findall(r"\./run ([a-z][\w-]*)", text) if name not in BRANCHES]
    found += [name for name in re.findall(r"`(\w+_test)`", text) if name not in NAMES and name not in CMAKE]
    paths = [path.rstrip("/") for path in re.findall(r"(?<![\w/.])([a-z]+/[\w./-]*\w)", re.sub(r"\]\([^)]*\)", "]", text))]
    found += [path for path in paths if path.split("/")[0] in FOLDERS - {"web"} and path.split("/")[1] != "*" and
              "NAME" not in path and not (ROOT / path).exists() and not list(ROOT.glob(f"{path}.*"))]
    return found


@unittest.skipUnless(len(FILES) > 100, "no checkout, or no git")
class Names(unittest.TestCase):
    def test_what_pages_name_is_there(self):
        for page in PAGES:
            with self.subTest(page=page.name):
                self.assertEqual([], missing(page.read_text()))

    def test_what_is_not_there_is_found(self):
        self.assertEqual(["./run nothing", "no_such_test", "scripts/none.sh", "host/vector/none.hpp", "scripts/comm"],
                         missing("`./run nothing` `no_such_test` scripts/none.sh `host/vector/none.hpp` scripts/comm"))
        self.assertEqual([], missing("`./run docs` `links_test` `python_tutorial_test` scripts/commits `host/vector`"))


if __name__ == "__main__":
    unittest.main()
