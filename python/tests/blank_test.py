"""A drawing without a line comes with a warning that says why."""

import subprocess
import sys
import unittest
import warnings

import numpy as np

import lineatlas
from support import CUBE_POSITIONS, CUBE_TRIANGLES, CUBE_VIEW, FolderTest, cube, dark_share

AWAY = lineatlas.View((4, 3, 5), (9, 9, 9))
PAST = lineatlas.View((0, 0, 5), (10, 0, 0))


def hidden_line() -> lineatlas.Mesh:
    """The only line that is asked for lies within a cube."""
    inside = np.array([[0.4, 0.5, 0.5], [0.6, 0.5, 0.5]])
    return lineatlas.Mesh(CUBE_POSITIONS, CUBE_TRIANGLES, polylines=[inside])


class Blank(unittest.TestCase):
    def said(self, model: lineatlas.Mesh, call: object = lineatlas.draw, **arguments) -> list:
        with warnings.catch_warnings(record=True) as found:
            warnings.simplefilter("always")
            drawn = call(model, size=(80, 60), **arguments)
        if isinstance(drawn, np.ndarray) and found:
            self.assertEqual(dark_share(drawn), 0)
        for warning in found:
            self.assertIs(warning.category, UserWarning)
            self.assertEqual(warning.filename, __file__)  # the file that called the package
        return [str(warning.message) for warning in found]

    def test_why(self) -> None:
        for call in (lineatlas.draw, lineatlas.to_svg, lineatlas.to_json):
            self.assertEqual(self.said(cube(), call, view=AWAY), [
                "no line is drawn: the model lies behind the camera, which looks away from it"])
            self.assertEqual(self.said(cube(), call, view=PAST), [
                "no line is drawn: none lies in the part of the model that the camera sees"])
            self.assertEqual(self.said(cube(), call, view=CUBE_VIEW, lines="boundary,file"), [
                "no line is drawn: the model has none of the kinds boundary, file"])
            self.assertEqual(self.said(lineatlas.Mesh([], []), call, view=CUBE_VIEW), [
                "no line is drawn: the model has no triangles and no lines"])
            self.assertEqual(self.said(hidden_line(), call, view=CUBE_VIEW, lines="file"), [
                "no line is drawn: surfaces hide those in the picture, or the style leaves them out"])
            self.assertEqual(self.said(cube(), call, view=CUBE_VIEW), [])
        self.assertEqual(self.said(cube(), view=CUBE_VIEW, lines="crease", crease=100), [
            "no line is drawn: the model has none of the kinds crease; a smaller crease angle "
            "finds more"])
        self.assertEqual(self.said(hidden_line(), view=CUBE_VIEW, lines="file",
                                   style=lineatlas.Style(hidden=True)), [])

    def test_of_every_method(self) -> None:
        for method in ("auto", "atlas", "exact", "spine", "item-buffer", "opengl"):
            options = lineatlas.Options(method=method)
            self.assertEqual(len(self.said(cube(), view=AWAY, options=options)), 1, method)
            self.assertEqual(self.said(cube(), view=CUBE_VIEW, options=options), [], method)

    def test_at_the_line_that_calls_a_renderer(self) -> None:
        with lineatlas.Renderer(cube()) as renderer:
            self.assertEqual(len(self.said(renderer, lineatlas.Renderer.draw, view=AWAY)), 1)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                with self.assertRaisesRegex(UserWarning, "no line is drawn"):
                    renderer.draw(size=(80, 60), view=AWAY)
            self.assertGreater(dark_share(renderer.draw(size=(80, 60), view=CUBE_VIEW)), 0)


class CommandLine(FolderTest):
    def test_says_it_in_one_line(self) -> None:
        path = self.folder / "a.png"
        done = subprocess.run([sys.executable, "-m", "lineatlas", "--scene", "clevis", "-o", path,
                               "--eye", "500,0,0", "--target", "900,0,0"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stderr, "lineatlas: no line is drawn: the model lies behind the camera, "
                         "which looks away from it\n")
        self.assertTrue(path.exists())


if __name__ == "__main__":
    unittest.main()
