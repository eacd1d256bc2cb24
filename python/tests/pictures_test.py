"""Pictures and paths are those of the tool."""

import json
import re
import subprocess
import sys
import unittest

import numpy as np

import lineatlas
from support import CUBE_VIEW, FolderTest, cube, dark_share, inflated, png_rows, run_tool


class AsTheTool(FolderTest):
    def saved(self, picture: np.ndarray) -> bytes:
        path = self.folder / "python.png"
        lineatlas.save(path, picture)
        return png_rows(path)

    def drawn_by_tool(self, *words: object) -> bytes:
        path = self.folder / "tool.png"
        run_tool("draw", "--scene", "clevis", "-o", path, "--size", "640x480", *words)
        return png_rows(path)

    def test_plain(self) -> None:
        scene = lineatlas.scene("clevis")
        picture = lineatlas.draw(scene.mesh, size=(640, 480), view=scene.view(0))
        self.assertEqual(picture.shape, (480, 640, 4))
        self.assertEqual(picture.dtype, np.uint8)
        self.assertGreater(dark_share(picture), 0.005)
        self.assertEqual(self.saved(picture), self.drawn_by_tool())

    def test_style_quality_and_lines(self) -> None:
        scene = lineatlas.scene("clevis")
        picture = lineatlas.draw(
            scene.mesh, size=(640, 480), view=scene.view(0), lines="crease,silhouette", crease=50,
            style=lineatlas.Style("pencil", width=3, fill="flat"),
            options=lineatlas.Options(quality="low"))
        self.assertEqual(self.saved(picture), self.drawn_by_tool(
            "--style", "pencil", "--width", 3, "--fill", "flat", "--quality", "low",
            "--lines", "crease,silhouette", "--crease", 50))

    def test_transparent(self) -> None:
        scene = lineatlas.scene("clevis")
        picture = lineatlas.draw(scene.mesh, size=(640, 480), view=scene.view(0),
                                 style="pencil", transparent=True)
        self.assertEqual(int(picture[0, 0, 3]), 0)
        self.assertEqual(self.saved(picture), self.drawn_by_tool("--style", "pencil",
                                                                 "--transparent"))

    def test_framed_file_of_another_axis(self) -> None:
        model = self.folder / "cube.off"
        mesh = cube()
        rows = [" ".join(map(str, p)) for p in mesh.positions]
        rows += ["3 " + " ".join(map(str, t)) for t in mesh.triangles]
        model.write_text("OFF\n8 12 0\n" + "\n".join(rows) + "\n")
        path = self.folder / "tool.png"
        run_tool("draw", model, "-o", path, "--size", "300x200", "--up", "z")
        self.assertEqual(self.saved(lineatlas.draw(model, size=(300, 200), up="z")),
                         png_rows(path))

    def test_paths(self) -> None:
        scene = lineatlas.scene("clevis")
        with lineatlas.Renderer(scene.mesh) as renderer:
            svg = renderer.to_svg(view=scene.view(0), style="technical")
            paths = json.loads(renderer.to_json(view=scene.view(0), style="technical"))["paths"]
        for extension in ("svg", "json"):
            run_tool("draw", "--scene", "clevis", "--style", "technical",
                     "-o", self.folder / f"tool.{extension}")
        theirs = (self.folder / "tool.svg").read_text()
        found = re.findall(r'<path [^>]*d="[^"]*"', svg)
        self.assertGreater(len(found), 50)
        self.assertEqual(found, re.findall(r'<path [^>]*d="[^"]*"', theirs))
        self.assertEqual(paths, json.loads((self.folder / "tool.json").read_text())["paths"])

    def test_dxf_and_pdf(self) -> None:
        scene = lineatlas.scene("clevis")
        sheet = {"page": "a4", "margin": "10mm", "fit_arcs": True}
        with lineatlas.Renderer(scene.mesh) as renderer:
            dxf = renderer.to_dxf(view=scene.view(0), style="technical", **sheet)
            pdf = renderer.to_pdf(view=scene.view(0), style="technical", title="Clevis", **sheet)
        run_tool("draw", "--scene", "clevis", "--style", "technical", "--page", "a4", "--margin",
                 "10mm", "--fit-arcs", "-o", self.folder / "tool.dxf")
        theirs = (self.folder / "tool.dxf").read_text()
        self.assertEqual(dxf, theirs[theirs.index("  0\nSECTION"):])  # without the comments at the start
        self.assertTrue(pdf.startswith(b"%PDF-") and pdf.endswith(b"%%EOF\n"))
        text = inflated(pdf)
        self.assertIn(b"841.889764", text)
        self.assertIn(b"(Clevis)", text)
        with self.assertRaises(lineatlas.UsageError):
            lineatlas.to_pdf(scene.mesh, page="a99")

    def test_command_line(self) -> None:
        path = self.folder / "module.png"
        subprocess.run([sys.executable, "-m", "lineatlas", "--scene", "clevis", "-o", path,
                        "--size", "640x480", "--style", "ink", "--set", "width=4"], check=True)
        self.assertEqual(png_rows(path), self.drawn_by_tool("--style", "ink", "--width", 4))
        svg = self.folder / "module.svg"
        subprocess.run([sys.executable, "-m", "lineatlas", "--scene", "clevis", "-o", svg],
                       check=True)
        self.assertTrue(svg.read_text().endswith("</svg>\n"))
        for extension, end in (("dxf", b"EOF\n"), ("pdf", b"%%EOF\n")):
            path = self.folder / f"module.{extension}"
            subprocess.run([sys.executable, "-m", "lineatlas", "--scene", "clevis", "-o", path],
                           check=True)
            self.assertTrue(path.read_bytes().endswith(end))

    def test_command_line_says_what_is_wrong(self) -> None:
        for words, code, said in ((["nothing.obj"], 1, "nothing.obj"), ([], 2, "MODEL"),
                                  (["--scene", "clevis", "--style", "none-such"], 2, "none-such")):
            done = subprocess.run(
                [sys.executable, "-m", "lineatlas", *words, "-o", self.folder / "a.png"],
                capture_output=True, text=True)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(said, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)


class Views(unittest.TestCase):
    def test_matrices_draw_what_the_view_does(self) -> None:
        view = lineatlas.View(eye=(0.5, 0.5, 5), target=(0.5, 0.5, 0), fov=90, near=1, far=10)
        eye_from_world = np.eye(4)
        eye_from_world[:3, 3] = (-0.5, -0.5, -5)
        projection = np.zeros((4, 4))
        projection[0, 0] = projection[1, 1] = 1
        projection[2, 2:] = (-(10 + 1) / (10 - 1), -2 * 10 * 1 / (10 - 1))
        projection[3, 2] = -1
        with lineatlas.Renderer(cube()) as renderer:
            expected = renderer.draw(size=(200, 200), view=view)
            camera = lineatlas.Camera(eye_from_world, projection)
            np.testing.assert_array_equal(camera.view, eye_from_world.astype(np.float32))
            difference = np.abs(renderer.draw(size=(200, 200), view=camera).astype(int) - expected)
        self.assertGreater(dark_share(expected), 0.005)
        self.assertLessEqual(int(difference.max()), 3)  # equal but for rounding

    def test_degrees_and_repr(self) -> None:
        view = lineatlas.View((4, 3, 5), np.array([0.5, 0.5, 0.5]), fov=60)
        self.assertAlmostEqual(view.fov, 60, places=4)
        self.assertEqual(eval(repr(view), {"View": lineatlas.View}).eye, view.eye)

    def test_module_frames_as_the_renderer(self) -> None:
        with lineatlas.Renderer(cube()) as renderer:
            self.assertEqual(repr(lineatlas.frame(cube(), size=(300, 200), up="z")),
                             repr(renderer.frame(size=(300, 200), up="z")))

    def test_refused(self) -> None:
        mesh = cube()
        for view in (lineatlas.View((1, 1, 1), (1, 1, 1)), lineatlas.View((np.nan, 0, 0), (0, 0, 0)),
                     lineatlas.View((0, 9, 0), (0, 0, 0)), lineatlas.View((9, 0, 0), (0, 0, 0), fov=180)):
            with self.assertRaises(lineatlas.UsageError):
                lineatlas.draw(mesh, view=view)
        for size in ((0, 10), (10, -1), (1 << 20, 10)):
            with self.assertRaisesRegex(lineatlas.UsageError, "side"):
                lineatlas.draw(mesh, size=size)
            with self.assertRaises(lineatlas.UsageError):
                lineatlas.draw(mesh, size=size, view=CUBE_VIEW)
        with self.assertRaisesRegex(lineatlas.UsageError, "up"):
            lineatlas.draw(mesh, up="w")
        with self.assertRaisesRegex(lineatlas.UsageError, "4, 4"):
            lineatlas.Camera(np.eye(3), np.eye(4))
        said = "; view and projection must be finite numbers that have an inverse$"
        for wrong, what in ((np.nan, "not finite"), (np.inf, "not finite"), (1e300, "not finite"),
                            (0, "singular")):
            with self.assertRaisesRegex(lineatlas.UsageError, "^camera: the view matrix is " + what + said):
                lineatlas.Camera(np.diag([wrong] * 4), np.eye(4))
            with self.assertRaisesRegex(lineatlas.UsageError,
                                        "^camera: the projection matrix is " + what + said):
                lineatlas.Camera(np.eye(4), np.diag([wrong] * 4))


class Styles(unittest.TestCase):
    def test_settings(self) -> None:
        style = lineatlas.Style("pencil", width=3, hidden=True, color=[0, 0.5, 1])
        style["cap-length"] = np.float32(7)
        self.assertEqual(style["width"], 3)
        self.assertEqual(style["cap_length"], 7)
        self.assertEqual(style["color"], [0, 0.5, 1])
        self.assertIs(style.settings()["hidden"], True)
        self.assertIn("width = 3", style.to_toml("mine"))

    def test_refused(self) -> None:
        style = lineatlas.Style()
        with self.assertRaisesRegex(lineatlas.UsageError, "width"):
            style["widht"] = 3
        with self.assertRaisesRegex(lineatlas.UsageError, "width"):
            lineatlas.Style(width=-1)
        with self.assertRaisesRegex(ValueError, "pencil"):
            lineatlas.Style("pencl")
        with self.assertRaises(lineatlas.FileError):
            lineatlas.Style("./no-such-style.toml")
        with self.assertRaises((TypeError, RuntimeError)):
            style["width"] = object()

    def test_that_ship(self) -> None:
        self.assertIn("pencil", lineatlas.styles())


if __name__ == "__main__":
    unittest.main()
