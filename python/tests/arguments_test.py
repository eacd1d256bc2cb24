"""Arguments of a wrong type end in one line that names them; names of files may be any bytes."""

import os
import subprocess
import sys
import unittest

import numpy as np

import lineatlas
from support import CUBE_POSITIONS, CUBE_VIEW, FolderTest, cube


class Refused(unittest.TestCase):
    def check(self, said: str, call: object, *arguments: object, **named: object) -> None:
        with self.assertRaises(TypeError) as caught:
            call(*arguments, **named)
        self.assertEqual(str(caught.exception), said)

    def test_of_drawings(self) -> None:
        self.check("view must be a View, such as View(eye, target), or a Camera, "
                   "not ((4, 3, 5), (0, 0, 0))",
                   lineatlas.draw, cube(), view=((4, 3, 5), (0, 0, 0)))
        self.check("size must be two whole numbers, width and height, not (640,)",
                   lineatlas.to_svg, cube(), size=(640,))
        self.check("style must be a Style, the name of one or the path of a style file, not 7",
                   lineatlas.draw, cube(), style=7)
        self.check("options must be an Options, not {'probes': 9}",
                   lineatlas.draw, cube(), options={"probes": 9})
        self.check("model must be a Mesh or the path of a file, not a value of type list",
                   lineatlas.draw, CUBE_POSITIONS.astype(float).tolist())
        for name, wrong in (("up", 3), ("lines", 3), ("crease", "sharp"), ("compute", None),
                            ("device", 0), ("interop", 0), ("transparent", "yes")):
            with self.assertRaisesRegex(TypeError, f"^{name} must be .*, not {wrong!r}$"):
                lineatlas.draw(cube(), **{name: wrong})
        with lineatlas.Renderer(cube()) as renderer:
            for name, wrong in (("page", 4), ("margin", 10), ("title", 5), ("tags", "no"),
                                ("plotter", "a"), ("size", "big")):
                with self.assertRaisesRegex(TypeError, f"^{name} must be ") as caught:
                    renderer.to_svg(**{name: wrong})
                self.assertNotIn("\n", str(caught.exception))

    def test_unknown_names(self) -> None:
        self.check('draw() has no argument "sizee"; did you mean "size"?',
                   lineatlas.draw, cube(), sizee=(64, 48))
        self.check('to_svg() has no argument "crese"; did you mean "crease" of Renderer()?',
                   lineatlas.to_svg, cube(), crese=20)
        self.check('Mesh() has no argument "triangle_groups"; did you mean "triangle_group"?',
                   lineatlas.Mesh, CUBE_POSITIONS, triangle_groups=[])
        self.check('frame() has no argument "sise"; did you mean "size"?',
                   lineatlas.frame, cube(), sise=(64, 48))
        self.check('Group() has no argument "xyz"; it has object, material, color',
                   lineatlas.Group, xyz=1)

    def test_of_styles(self) -> None:
        wanted = 'width must be a number above 0 and at most 1000 pixels, or a length on paper as "0.5mm", not '
        self.check(wanted + "None", lineatlas.Style, width=None)
        self.check(wanted + "[1, 'a']", lineatlas.Style, width=[1, "a"])
        style = lineatlas.Style()
        with self.assertRaisesRegex(TypeError, "^hidden must be true or false, not None$"):
            style["hidden"] = None
        self.check("base must be the name of a style or the path of a style file, not 3",
                   lineatlas.Style, 3)
        for width in (3, 3.0, "3", np.float32(3), np.int64(3), np.array(3)):
            self.assertEqual(lineatlas.Style(width=width)["width"], 3)

    def test_of_views_and_meshes(self) -> None:
        self.check("eye must be three numbers, not (1, 2)", lineatlas.View, (1, 2), (0, 0, 0))
        self.check("fov must be a number, not 'wide'",
                   lineatlas.View, (1, 2, 3), (0, 0, 0), fov="wide")
        self.check("projection must be a (4, 4) array of numbers, not 'none'",
                   lineatlas.Camera, np.eye(4), "none")
        self.check("keys must be a dictionary with a View for each frame, not [0, 1]",
                   lineatlas.camera_path, [0, 1])
        self.check("frames must be a whole number, not 'all'", lineatlas.turntable, cube(), "all")
        self.check("color must be three numbers, not 'red'", lineatlas.Group, color="red")
        self.check("groups must be a list of Group and names of materials, not 3",
                   cube, triangle_group=[0] * 12, groups=3)
        self.check("polylines must be a list of lines, not 3",
                   lineatlas.Mesh, CUBE_POSITIONS, polylines=3)
        with self.assertRaisesRegex(lineatlas.UsageError, '^probes must be one of 1, 4, 9, 16, not "many"$'):
            lineatlas.Options(probes="many")


class NamesOfFiles(FolderTest):
    def test_a_surrogate_without_its_pair(self) -> None:
        said = r"^{}: the text '\\ud800{}' has a surrogate without its pair, which cannot be encoded$"
        for name, call in (("path", lineatlas.load), ("model", lineatlas.draw)):
            with self.assertRaisesRegex(TypeError, said.format(name, ".obj")):
                call("\ud800.obj")
        with self.assertRaisesRegex(TypeError, said.format("base", "")):
            lineatlas.Style("\ud800")
        with self.assertRaisesRegex(TypeError, said.format("pen", ".png")):
            lineatlas.Style(pen="\ud800.png")

    def test_bytes_that_are_no_text(self) -> None:
        with self.assertRaisesRegex(lineatlas.FileError, r'"\?\.obj"'):
            lineatlas.load("\udc80.obj")
        path = os.fsdecode(os.fsencode(self.folder) + b"/\x80.obj")
        with open(path, "wb") as file:
            file.write(b"o G\xfcnter\nusemtl gr\xfcn\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                       b"f 1 2 3\nf 1 2 1\n")
        mesh = lineatlas.load(path)
        self.assertEqual((mesh.groups[0].object, mesh.groups[0].material),
                         (r"G\xfcnter", r"gr\xfcn"))
        self.assertTrue(all(isinstance(note, str) for note in mesh.notes))
        self.assertIn("<path", lineatlas.to_svg(mesh))


class NumPy(unittest.TestCase):
    def test_that_is_missing_is_said(self) -> None:
        words = ("import sys; sys.modules['numpy'] = None\n"
                 "try: import lineatlas\n"
                 "except ImportError as error: print(error)")
        done = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True)
        self.assertIn(f"lineatlas needs NumPy, which {sys.executable} cannot import", done.stdout)
        self.assertEqual(done.stdout.count("\n"), 1, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
