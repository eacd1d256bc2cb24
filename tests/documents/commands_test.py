"""The commands of README and docs that need nothing but the tool run as they stand, in the order of their page, and end with 0; it
reads the files of TOML that pages show."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from documents import PAGES, ROOT, blocks

TOOL = os.environ["LINEATLAS_TOOL"]

#: What is not run, and why.
SKIPPED = {
    r"lineatlas view": "opens a window",
    r"16000x12000": "takes a minute",
    r"model\.(session|json)": "is what the viewer saves",
    r"LINEATLAS_KERNEL_DIR|POCL_|perf ": "is of a kernel folder, PoCL's or perf's own",
    r"lineatlas bench |--kernels |--assembly": "is walked with the page of profiling",
    r"--certify|lineatlas check": "needs the module of rays",  # unless it is there, see setUp
}

# The tool, on pictures and sequences that are small enough for a test. Everything else is as the page has it.
WRAPPER = """#!/bin/bash
case " $* " in
*" draw "*" --views "* | *" draw "*" --size "* | *" draw "*" --page "* | *" draw "*" --scale "*) size=() ;;
*" draw "*) size=(--size 200x150) ;;
esac
case " $* " in
*" --frames "* | *" --resume "*) ;;
*" --turntable "* | *" --camera-path "*) size+=(--frames 0-2) ;;
esac
exec "$LINEATLAS_TOOL" "$@" "${size[@]}"
"""

IS_TOOL = re.compile(r"^(?:[A-Z_]+=\S+ )*(?:build/release/)?lineatlas ")


def commands(page):
    """The lines of a page's sh blocks that are the tool's."""
    for block in blocks(page.read_text(), "sh"):
        for line in block.replace("\\\n", " ").splitlines():
            if IS_TOOL.match(line.strip()):
                yield line.strip()


def why_not(line, has_rays):
    for pattern, reason in SKIPPED.items():
        if re.search(pattern, line) and not (reason.endswith("rays") and has_rays):
            return reason
    return ""


def write_stl(path, obj):
    """The triangles of an OBJ file in metres, as fans, as STL in millimetres."""
    vertices, facets = [], []
    for line in obj.read_text().splitlines():
        kind, *words = line.split() or [""]
        if kind == "v":
            vertices.append(" ".join(str(1000 * float(word)) for word in words))
        elif kind == "f":
            corners = [vertices[int(word.split("/")[0]) - 1] for word in words]
            facets += [(corners[0], *corners[i:i + 2]) for i in range(1, len(corners) - 1)]
    path.write_text("solid\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {place}\n" for place in facet) + "endloop\nendfacet\n"
        for facet in facets) + "endsolid\n")


class Commands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        bin_ = self.folder / "build/release"
        bin_.mkdir(parents=True)
        (bin_ / "lineatlas").write_text(WRAPPER)
        (bin_ / "lineatlas").chmod(0o755)
        self.environment = {**os.environ, "PATH": f"{bin_}:{os.environ['PATH']}", "LINEATLAS_TOOL": TOOL}
        for name, scene in [("model", "clevis"), ("house", "house"), ("small_house", "house"), ("koala", "clevis")]:
            self.run_line(f"lineatlas scene {scene} -o {name}.obj")
        for name in ["part", "valve", "flange"]:
            write_stl(self.folder / f"{name}.stl", self.folder / "model.obj")
        pin = (ROOT / "tests/fuzz/inputs/step/pin.step").read_bytes()
        for name in ["part", "flange", "bracket"]:
            (self.folder / f"{name}.step").write_bytes(pin)
        (self.folder / "walk.json").write_text(next(blocks((ROOT / "docs/output.md").read_text(), "json")))
        (self.folder / "widths.toml").write_text(next(blocks((ROOT / "docs/solves.md").read_text(), "toml")))
        said = self.run_line("lineatlas --version").stdout
        self.has_rays, self.has_step = [re.search(rf"^{part}.*not", said, re.MULTILINE) is None for part in ["rays", "brep"]]

    def run_line(self, line):
        """A command of a page, in the shell that it is written for."""
        return subprocess.run(["bash", "-c", line], cwd=self.folder, env=self.environment, capture_output=True, text=True)

    def test_every_command_runs(self):
        ran = 0
        for page in PAGES:
            for line in commands(page):
                if why_not(line, self.has_rays) or (".step" in line and not self.has_step):
                    continue
                with self.subTest(page=page.name, line=line):
                    done = self.run_line(line)
                    self.assertEqual(0, done.returncode, done.stderr)
                    for name in re.findall(r" (?:-o|>) (\S+)", line):
                        name = name % 1 if "%" in name else name
                        self.assertTrue((self.folder / name).exists(), f"{name} is not there")
                    ran += 1
        self.assertGreater(ran, 30)

    def read(self, name, text):
        """Draws by a TOML file that has the text: a session, a sheet or a style."""
        (self.folder / name).write_text(text)
        if text.startswith("session = "):  # of a model with the parts that it hides
            text = re.sub(r"^model = .*", 'model = "model.obj"', re.sub(r"^hide = .*\n", "", text, flags=re.MULTILINE),
                          flags=re.MULTILINE)
            (self.folder / name).write_text(re.sub(r'"\+[xz]=.*?"', '"x=50%"', text))
            return self.run_line(f"lineatlas draw {name} -o block.svg")
        if "[[views]]" in text:
            return self.run_line(f"lineatlas draw valve.stl -o block.svg --views {name}")
        return self.run_line(f"lineatlas draw model.obj -o block.svg --style ./{name}")

    def test_files_of_toml_are_read(self):
        pens = self.run_line("mkdir marks && lineatlas styles --write-pens marks && mv marks/pencil.png marks/chalk.png")
        self.assertEqual(0, pens.returncode, pens.stderr)
        read = 0
        for page in PAGES:
            for number, text in enumerate(blocks(page.read_text(), "toml")):
                with self.subTest(page=page.name, number=number):
                    done = self.read(f"{page.stem}{number}.toml", text)
                    self.assertEqual(0, done.returncode, done.stderr)
                    read += 1
        self.assertGreater(read, 4)

    def test_a_file_of_toml_that_is_wrong_is_refused(self):
        for key, text in [("widht", "widht = 2\n"), ("stlye", "session = 1\nmodel = \"model.obj\"\nstlye = 1\n"),
                          ("scael", "scael = 1\n[[views]]\nview = \"front\"\n")]:
            done = self.read("wrong.toml", text)
            self.assertNotEqual(0, done.returncode)
            self.assertIn(key, done.stderr)

    def test_circles_are_circles(self):
        page = (ROOT / "docs/solves.md")
        lines = [line for line in commands(page) if "round.dxf" in line or "found.dxf" in line]
        self.assertEqual(2, len(lines))
        for line in lines:
            if ".step" in line and not self.has_step:
                continue
            self.assertEqual(0, self.run_line(line).returncode)
            drawing = (self.folder / re.search(r"-o (\S+)", line)[1]).read_text()
            self.assertRegex(drawing, r"\nCIRCLE\r?\n", line)

    def test_the_same_command_makes_the_same_bytes(self):
        for kind in ["svg", "pdf", "dxf", "json", "png"]:
            first, second = [self.folder / f"{name}.{kind}" for name in ("first", "second")]
            for path in (first, second):
                self.assertEqual(0, self.run_line(f"lineatlas draw model.obj -o {path.name}").returncode)
            self.assertEqual(first.read_bytes(), second.read_bytes(), kind)

    def test_a_command_that_is_wrong_fails(self):
        self.assertEqual(2, self.run_line("lineatlas draw model.obj -o a.svg --nothing").returncode)
        self.assertEqual(1, self.run_line("lineatlas draw none.obj -o a.svg").returncode)

    def test_the_styles_of_the_readme_are_those_of_the_tool(self):
        said = self.run_line("lineatlas styles").stdout
        line = re.search(r"lineatlas styles +# (.*)", (ROOT / "README.md").read_text())[1]
        self.assertEqual(sorted(re.findall(r"^(\w+)  ", said, re.MULTILINE)), sorted(line.split(", ")))


if __name__ == "__main__":
    unittest.main()
