"""A table of measured figures says of which run they are: a commit or a date stands in the table, in the text before it, up to the
table or heading above, or in the paragraph after it. The table that scripts/figures.py has measured is that of its JSON."""

import json
import os
import re
import subprocess
import sys
import unittest

from documents import PAGES, ROOT, without_blocks

sys.path.append(str(ROOT / "scripts"))
import figures  # noqa: E402

UNIT = re.compile(r"(?<![\w'])(ms|s|us|seconds|milliseconds|minutes|KiB|MB|GB|GiB|MiB|kB|fps)\b|%")
FIGURE = re.compile(r"\d\s?(ms|s|us|KiB|MB|GB|GiB|MiB|kB|%)(?!\w)")
RUN = re.compile(r"\b20\d\d-\d\d-\d\d\b|`[0-9a-f]{7,8}`|\basserts these limits\b")


def is_measured(table):
    """True if columns, or several cells, have units of what is measured."""
    rows = [re.sub(r"`[^`]*`", "", row) for row in table.splitlines()]
    if "target" in rows[0]:
        return False
    cells = [cell for row in rows[2:] for cell in row.split("|") if len(cell) < 30 and FIGURE.search(cell)]
    return UNIT.search(rows[0]) is not None or len(cells) > 1


def without_run(text):
    """The first rows of tables of figures that name no run."""
    found = []
    for section in re.split(r"^#+ .*$", without_blocks(text), flags=re.MULTILINE):
        parts = re.split(r"((?:^\|.*\n)+)", section, flags=re.MULTILINE)  # text, table, text, table, text
        for before, table, after in zip(parts[::2], parts[1::2], parts[2::2]):
            paragraph = after.strip().split("\n\n")[0]
            named = before + table + ("" if paragraph.endswith(":") else paragraph)  # not what leads to the next table
            if is_measured(table) and not RUN.search(named):
                found.append(table.splitlines()[0])
    return found


class Figures(unittest.TestCase):
    def test_tables_name_their_run(self):
        measured = 0
        for page in PAGES:
            with self.subTest(page=page.name):
                text = page.read_text()
                self.assertEqual([], without_run(text))
                measured += sum(map(is_measured, re.findall(r"(?:^\|.*\n)+", text, re.MULTILINE)))
        self.assertGreater(measured, 20)

    def test_a_table_without_a_run_is_found(self):
        table = "| model | ms |\n|---|---|\n| ship | 5.1 |\n"
        self.assertEqual(["| model | ms |"], without_run(f"# A\n\nAt `af8bad9`.\n\n## B\n\n{table}"))
        self.assertEqual([], without_run(f"# A\n\nMedians (2026-11-25):\n\n{table}"))
        self.assertEqual([], without_run(f"# A\n\n{table}\nMedians (2026-11-25).\n\n"))
        self.assertEqual(["| model | ms |"], without_run(f"# A\n\n{table}\nMedians (2026-11-25):\n\n{table}"))
        self.assertEqual(["| model | ms |"], without_run(f"# A\n\nMedians (2026-11-25):\n\n{table}\nThe next.\n\n{table}"))
        cells = "| model | first | second |\n|---|---|---|\n| ship | 5 ms | 6 ms |\n"
        self.assertEqual(["| model | first | second |"], without_run(cells))
        self.assertEqual([], without_run("| key | default |\n|---|---|\n| `width` | `2` |\n"))

    def test_the_table_of_drawings_is_that_of_its_json(self):
        text = (ROOT / "docs/quality.md").read_text()
        self.assertIn(figures.table(), text)
        run = json.loads(figures.FILE.read_text())["run"]
        self.assertIn(f"`{run['commit']}` of {run['date']}, [command, machine and figures](figures/{figures.FILE.name})", text)
        self.assertNotIn("/", run["command"])  # models by their names

    def test_measuring_refuses_to_drop_models(self):
        models = re.findall(r"--model (\S+)", json.loads(figures.FILE.read_text())["run"]["command"])
        self.assertGreater(len(models), 2)
        self.assertEqual([], figures.left_out([f"a/{model}" for model in models]))
        done = subprocess.run([sys.executable, figures.__file__, "measure", *models[1:]], capture_output=True, text=True)
        self.assertEqual(2, done.returncode)
        self.assertIn(f"the rows of {models[0]}:", done.stderr)

    def test_measuring_leaves_the_file_whole_if_the_tool_fails(self):
        models = re.findall(r"--model (\S+)", json.loads(figures.FILE.read_text())["run"]["command"])
        before = figures.FILE.read_bytes()
        done = subprocess.run([sys.executable, figures.__file__, "measure", *models], capture_output=True, text=True,
                              env={**os.environ, "LINEATLAS_TOOL": "false"})
        self.assertEqual(2, done.returncode)
        self.assertIn("name the tool's --commit", done.stderr)
        done = subprocess.run([sys.executable, figures.__file__, "measure", *models, "--commit", "0"], capture_output=True, text=True,
                              env={**os.environ, "LINEATLAS_TOOL": "false"})
        self.assertEqual(1, done.returncode)
        self.assertEqual(before, figures.FILE.read_bytes())


if __name__ == "__main__":
    unittest.main()
