"""Turntables and camera paths are those of the tool; a loop over them says how far it is, and stops."""

import json
import re
import unittest

import lineatlas
from support import FolderTest, cube, run_tool

SIZE = (80, 60)


class Sequences(FolderTest):
    def paths(self, name: str) -> list:
        return re.findall('<path d="[^"]*', (self.folder / name).read_text())

    def write_bar(self) -> str:
        """A long bar off the origin, upright along z."""
        path = self.folder / "bar.obj"
        corners = [(x, y, z) for z in (0, 2) for x, y in ((10, 0), (18, 0), (18, 1), (10, 1))]
        faces = ("1 4 3 2", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8")
        path.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "".join(f"f {f}\n" for f in faces))
        return str(path)

    def test_a_turntable_is_the_tool_s(self) -> None:
        bar = self.write_bar()
        run_tool("draw", bar, "--up", "z", "--turntable", 4, "--size", "80x60", "-o", self.folder / "%d.svg")
        views = lineatlas.turntable(bar, 4, size=SIZE, up="z")
        self.assertEqual(len(views), 4)
        for number, view in enumerate(views):
            drawn = re.findall('<path d="[^"]*', lineatlas.to_svg(bar, size=SIZE, view=view))
            self.assertGreater(len(drawn), 3)
            self.assertEqual(drawn, self.paths(f"{number}.svg"))
        self.assertNotEqual(self.paths("0.svg"), self.paths("1.svg"))

    def test_a_turntable_goes_around_the_middle(self) -> None:
        views = lineatlas.turntable(cube(), 2, view="front", projection="orthographic")
        self.assertEqual(views[0].projection, "orthographic")
        x, y, z = views[0].eye
        self.assertAlmostEqual(x, 0.5, 5)
        for got, expected in zip(views[1].eye, (0.5, y, 1 - z)):
            self.assertAlmostEqual(got, expected, 4)

    def test_a_camera_path_is_the_tool_s(self) -> None:
        bar = self.write_bar()
        keys = {1: lineatlas.View((30, 9, 9), (14, 0, 1), (0, 0, 1)),
                4: lineatlas.View((14, 30, 9), (14, 0, 1), (0, 0, 1), fov=60)}
        (self.folder / "path.json").write_text(json.dumps({"keys": [
            {"frame": frame, "eye": view.eye, "target": view.target, "up": view.up, "fov": view.fov}
            for frame, view in keys.items()]}))
        run_tool("draw", bar, "--camera-path", self.folder / "path.json", "--size", "80x60", "-o",
                 self.folder / "%d.svg")
        views = lineatlas.camera_path(keys)
        self.assertEqual(len(views), 4)
        for number, view in enumerate(views, 1):
            drawn = re.findall('<path d="[^"]*', lineatlas.to_svg(bar, size=SIZE, view=view))
            self.assertEqual(drawn, self.paths(f"{number}.svg"))
        self.assertEqual((views[0].eye, views[-1].eye), (keys[1].eye, keys[4].eye))

    def test_a_loop_stops_within_a_frame(self) -> None:
        """As docs/python.md has it: what a frame's own progress asks is asked in the middle of one."""
        said, drawn = [], []
        views = lineatlas.turntable(cube(), 5, size=SIZE)
        with lineatlas.Renderer(cube()) as renderer, self.assertRaises(lineatlas.Cancelled):
            for number, view in enumerate(views):
                def progress(done: float) -> bool:
                    said.append((number + done) / len(views))
                    return said[-1] < 0.5
                drawn.append(renderer.to_svg(size=SIZE, view=view, progress=progress))
        self.assertEqual(len(drawn), 2)
        self.assertEqual(said, sorted(said))
        self.assertGreaterEqual(said[-1], 0.5)

    def test_refusals(self) -> None:
        view = lineatlas.View((1, 2, 3), (0, 0, 0))
        for call, pattern in (
                (lambda: lineatlas.turntable(cube(), 0), "frames must be from 1"),
                (lambda: lineatlas.turntable(cube(), 3, up=(0, 0, 0)), "up must be an axis"),
                (lambda: lineatlas.turntable(lineatlas.Mesh([], []), 3), "nothing to frame"),
                (lambda: lineatlas.camera_path({}), "at least one key"),
                (lambda: lineatlas.camera_path({2e6: view}), "from -1000000 to 1000000")):
            with self.assertRaisesRegex(lineatlas.UsageError, pattern):
                call()
        self.assertEqual(lineatlas.camera_path({0.2: view, 0.8: view}), [])


if __name__ == "__main__":
    unittest.main()
