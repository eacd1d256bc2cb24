"""Views that frame a model leave out a tiny part far away, as the tool does, and warn of it."""

import unittest
import warnings

import numpy as np

import lineatlas
from support import FolderTest, cube, run_tool

SIDE = 21


def sheet(stray_lines: int) -> lineatlas.Mesh:
    """A wavy sheet of 800 triangles and a side of 1, and lines 22 away from it."""
    x, y = np.meshgrid(np.arange(SIDE), np.arange(SIDE))
    z = np.arange(SIDE * SIDE) % 3
    points = np.column_stack([x.ravel(), y.ravel(), z]) / 20
    corners = [v + y * SIDE for y in range(SIDE - 1) for v in range(SIDE - 1)]
    triangles = [t for v in corners for t in ((v, v + 1, v + SIDE), (v + 1, v + SIDE + 1, v + SIDE))]
    lines = [np.array([[22, i, 0], [22.1, i, 0]], float) for i in range(stray_lines)]
    return lineatlas.Mesh(points, triangles, polylines=lines)


class Framing(FolderTest):
    def said(self, call, *arguments, **options) -> tuple:
        with warnings.catch_warnings(record=True) as found:
            warnings.simplefilter("always")
            result = call(*arguments, **options)
        for warning in found:
            self.assertIs(warning.category, UserWarning)
            self.assertEqual(warning.filename, __file__)
        return result, [str(warning.message) for warning in found]

    def test_a_stray_line_far_away_is_left_out(self) -> None:
        alone, said = self.said(lineatlas.frame, sheet(0))
        self.assertEqual(said, [])
        view, said = self.said(lineatlas.frame, sheet(1))
        self.assertEqual(repr(view), repr(alone))
        self.assertEqual(len(said), 1)
        self.assertRegex(said[0], r"^1 of \d+ triangles and lines lie far .*; they are not framed, .* 15.\d+ times as wide")
        with lineatlas.Renderer(sheet(1)) as renderer:
            view, said_again = self.said(renderer.frame)
            self.assertEqual((repr(view), said_again), (repr(alone), said))

    def test_every_drawing_without_a_view_says_so(self) -> None:
        mesh, view = sheet(1), lineatlas.frame(sheet(0))
        for call in (lineatlas.draw, lineatlas.to_svg, lineatlas.to_json, lineatlas.intervals):
            _, said = self.said(call, mesh, size=(80, 60))
            self.assertEqual(len(said), 1, call)
            _, said = self.said(call, mesh, size=(80, 60), view=view)
            self.assertEqual(said, [], call)
            _, said = self.said(call, cube(), size=(80, 60))
            self.assertEqual(said, [], call)

    def test_more_of_them_are_framed(self) -> None:
        view, said = self.said(lineatlas.frame, sheet(10))
        self.assertGreater(view.shown_height, 4)
        self.assertRegex(said[0], "the picture is 16.[0-9]+ times as wide for their sake$")

    def test_as_the_tool_does(self) -> None:
        mesh = sheet(1)
        path = self.folder / "m.obj"
        line = mesh.polylines[0]
        path.write_text("".join(f"v {p[0]!r} {p[1]!r} {p[2]!r}\n" for p in mesh.positions.tolist())
                        + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in mesh.triangles)
                        + f"l {line[0] + 1} {line[1] + 1}\n")
        run_tool("draw", path, "-o", self.folder / "m.svg", "--up", "y", "--style", "plain", "--size", "80x60")
        own, _ = self.said(lineatlas.to_svg, path, size=(80, 60))
        drawn = (self.folder / "m.svg").read_text()
        self.assertIn("<path", own)
        self.assertEqual(own[own.index("<path"):], drawn[drawn.index("<path"):])


if __name__ == "__main__":
    unittest.main()
