"""The recipes of docs/python.md run, beside the programs that they are for."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import numpy as np
from support import FolderTest

import lineatlas

DOCUMENT = pathlib.Path(__file__).parents[2] / "docs" / "python.md"
LONGEST = 30  # lines


def recipe(heading: str) -> str:
    section = DOCUMENT.read_text(encoding="utf-8").split(f"\n### {heading}\n")[1]
    return re.search(r"```python\n(.*?)```", section, re.DOTALL).group(1)


class Recipes(FolderTest):
    def setUp(self) -> None:
        super().setUp()
        before = pathlib.Path.cwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)

    def need(self, module: str, package: str) -> None:
        if importlib.util.find_spec(module) is None:
            self.skipTest(f"{module} is not installed (apt install {package})")

    def run_here(self, heading: str) -> dict:
        text = recipe(heading)
        self.assertTrue(10 <= len(text.splitlines()) <= LONGEST, heading)
        names: dict = {"np": np}
        exec(compile(text, heading, "exec"), names)
        return names

    def test_meshio(self) -> None:
        self.need("meshio", "python3-meshio")
        names = self.run_here("meshio")
        self.assertEqual(len(names["skin"]), 6)  # two tetrahedra have eight faces; the shared one counts twice and is left out
        found = lineatlas.intervals(names["mesh"], view=names["lineatlas"].frame(names["mesh"], up="z"), hidden=True)
        edges = {(tuple(sorted(edge)), lineatlas.LineKind(kind).name)
                 for edge, kind in zip(found["edge"].tolist(), found["kind"])}
        sharp = {edge for edge, kind in edges if kind == "crease"}
        self.assertLessEqual({(1, 2), (2, 3), (1, 3)}, sharp)  # the three edges of that face, between the materials
        self.assertEqual(len({edge for edge, _ in edges}), 9)
        self.assertIn("material 7", (self.folder / "solid.svg").read_text())

    def test_matplotlib(self) -> None:
        self.need("matplotlib", "python3-matplotlib")
        os.environ["MPLBACKEND"] = "agg"
        names = self.run_here("matplotlib and Jupyter")
        shown = sum(len(lines.get_segments()) for lines in names["axes"].collections)
        self.assertEqual(shown, len(names["found"]))
        self.assertGreater(shown, 100)
        self.assertGreater((self.folder / "kinds.svg").stat().st_size, 10000)

    def test_vtk(self) -> None:
        self.need("vtk", "python3-vtk9")
        names = self.run_here("VTK")
        width, height = names["size"]
        self.assertEqual(names["lines"].shape, (height, width, 4))
        self.assertGreater((names["lines"][..., 3] > 128).mean(), 0.003)
        # VTK's own product of both matrices brings points of the model to the same pixels.
        whole = names["rows"](names["camera"].GetCompositeProjectionTransformMatrix(width / height, -1, 1))
        found = lineatlas.intervals(names["mesh"], size=names["size"], view=names["view"])
        clip = np.c_[found["p_world"], np.ones(len(found))] @ whole.T
        pixels = (clip[:, :2] / clip[:, 3:] * (1, -1) + 1) / 2 * (width, height)
        self.assertLess(np.abs(pixels - found["p"]).max(), 0.01)

    def test_freecad(self) -> None:
        program = shutil.which("freecadcmd")
        if program is None:
            self.skipTest("FreeCAD is not installed (apt install freecad)")
        if not (pathlib.Path(lineatlas.__file__).parent / "lib/lineatlas/lineatlas-brep.so").exists():
            self.skipTest("lineatlas-brep is not built (apt install libocct-data-exchange-dev)")
        text = recipe("FreeCAD")
        self.assertTrue(10 <= len(text.splitlines()) <= LONGEST)
        # The rims of the hole (radius 9) and of the pin (radius 5) are wholly visible and drawn once.
        check = """
import numpy
found = lineatlas.intervals(mesh, size=(900, 600), view=view)
p, q = found["p_world"], found["q_world"]
for height, radius, middle in ((8, 9, (20, 20)), (20, 5, (45, 20))):
    on = numpy.ones(len(found), bool)
    for end in (p, q):
        away = numpy.hypot(*(end[:, :2] - middle).T)
        on &= (abs(end[:, 2] - height) < 1e-3) & (abs(away - radius) < 1e-2)
    print("rim", numpy.linalg.norm(p[on] - q[on], axis=1).sum() / (2 * numpy.pi * radius))
"""
        script = self.folder / "recipe.py"
        script.write_text(text + check)
        package = str(pathlib.Path(lineatlas.__file__).parents[1])
        ended = subprocess.run([program, str(script)], capture_output=True, text=True, stdin=subprocess.DEVNULL,
                               env=os.environ | {"PYTHONPATH": package, "HOME": str(self.folder)})
        said = ended.stdout + ended.stderr
        rims = [float(share) for share in re.findall(r"^rim (.*)$", said, re.MULTILINE)]
        self.assertEqual(len(rims), 2, said)
        for share in rims:
            self.assertTrue(0.99 < share <= 1.0001, rims)
        self.assertGreater((self.folder / "part.svg").read_text().count("<path "), 10)


if __name__ == "__main__":
    sys.exit(unittest.main())
