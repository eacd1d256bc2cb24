"""What moves, changes its shape and is hidden; what is seen at a point; calls that tell how far they are."""

import os
import pathlib
import signal
import tempfile
import unittest

import numpy as np

import lineatlas
from support import CUBE_POSITIONS, CUBE_TRIANGLES, CUBE_VIEW, cube

SIZE = (320, 240)
SEEN = {"size": SIZE, "view": CUBE_VIEW}


def two_cubes() -> lineatlas.Mesh:
    """Objects 0, and 1 two units to its right."""
    positions = np.concatenate([CUBE_POSITIONS, CUBE_POSITIONS + (2, 0, 0)])
    triangles = np.concatenate([CUBE_TRIANGLES, CUBE_TRIANGLES + len(CUBE_POSITIONS)])
    return lineatlas.Mesh(positions, triangles, triangle_object=np.repeat([0, 1], len(CUBE_TRIANGLES)))


def two(**arguments) -> lineatlas.Renderer:
    return lineatlas.Renderer(two_cubes(), separate_objects=True, compute="cpp", **arguments)


def places(found: np.ndarray) -> np.ndarray:
    return np.sort(np.concatenate([found["p"], found["q"]]), axis=0)


class Hiding(unittest.TestCase):
    def test_of_pictures_and_paths(self) -> None:
        with two() as renderer, lineatlas.Renderer(cube(), compute="cpp") as alone:
            self.assertEqual(len(renderer.objects), 2)
            both = renderer.intervals(**SEEN)
            picture = renderer.draw(**SEEN)
            renderer.hide([1])
            np.testing.assert_allclose(places(renderer.intervals(**SEEN)), places(alone.intervals(**SEEN)), atol=0.01)
            np.testing.assert_array_equal(renderer.draw(**SEEN), alone.draw(**SEEN))
            renderer.hide([])
            self.assertEqual(len(renderer.intervals(**SEEN)), len(both))
            np.testing.assert_array_equal(renderer.draw(**SEEN), picture)

    def test_before_the_first_picture(self) -> None:
        with two() as renderer, lineatlas.Renderer(cube(), compute="cpp") as alone:
            renderer.hide([1])
            np.testing.assert_array_equal(renderer.draw(**SEEN), alone.draw(**SEEN))

    def test_what_there_is_not(self) -> None:
        with two() as renderer:
            for objects in ([2], [-1], 1):
                with self.assertRaises(lineatlas.UsageError):
                    renderer.hide(objects)
            with self.assertRaises(TypeError):
                renderer.hide("all")


def ball(stretch: float = 1) -> lineatlas.Mesh:
    """A sphere of radius 1, along x longer by `stretch`."""
    rings, sides = 24, 48
    polar = np.linspace(0, np.pi, rings + 1)[1:-1, None]
    around = np.linspace(0, 2 * np.pi, sides, endpoint=False)[None, :]
    belt = np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around),
                     np.cos(polar) + 0 * around], axis=-1).reshape(-1, 3)
    positions = np.concatenate([belt, [(0, 0, 1), (0, 0, -1)]]) * (stretch, 1, 1)
    top, bottom, last = len(belt), len(belt) + 1, (rings - 2) * sides
    triangles = []
    for j in range(sides):
        k = (j + 1) % sides
        triangles += [(top, j, k), (bottom, last + k, last + j)]
        for i in range(0, last, sides):
            triangles += [(i + j, i + sides + j, i + k), (i + k, i + sides + j, i + sides + k)]
    return lineatlas.Mesh(positions, triangles)


class SmoothSilhouettes(unittest.TestCase):
    def length(self, renderer: lineatlas.Renderer) -> float:
        found = renderer.intervals(size=(400, 400), view=lineatlas.View((0, -10, 0), (0, 0, 0), up=(0, 0, 1), fov=30))
        self.assertEqual(set(found["kind"]), {lineatlas.LineKind.silhouette})
        return float(np.linalg.norm(found["q"] - found["p"], axis=1).sum())

    def test_follow_the_surface(self) -> None:
        # At distance 10 the outline of a ball is a circle 0.1 before its middle, of radius sqrt(0.99).
        radius = np.sqrt(0.99) / 9.9 * 200 / np.tan(np.radians(15))
        with lineatlas.Renderer(ball(), silhouettes="smooth", compute="cpp") as renderer:
            self.assertAlmostEqual(self.length(renderer) / (2 * np.pi * radius), 1, delta=0.002)

    def test_of_another_shape(self) -> None:
        with lineatlas.Renderer(ball(), silhouettes="smooth", compute="cpp") as renderer, \
                lineatlas.Renderer(ball(1.5), silhouettes="smooth", compute="cpp") as wanted:
            renderer.set_positions(ball(1.5).positions)
            self.assertAlmostEqual(self.length(renderer), self.length(wanted), delta=0.5)

    def test_which_there_are(self) -> None:
        with self.assertRaisesRegex(lineatlas.UsageError, "silhouettes must be auto, smooth, mesh, not round"):
            lineatlas.Renderer(ball(), silhouettes="round")
        with self.assertRaisesRegex(TypeError, "silhouettes"):
            lineatlas.Renderer(ball(), silhouettes=3)


class Parts(unittest.TestCase):
    def other(self) -> lineatlas.Mesh:
        """The second of two_cubes()."""
        return lineatlas.Mesh(CUBE_POSITIONS + (2, 0, 0), CUBE_TRIANGLES)

    def expect_same(self, renderer: lineatlas.Renderer, wanted: lineatlas.Renderer) -> None:
        np.testing.assert_allclose(places(renderer.intervals(**SEEN)), places(wanted.intervals(**SEEN)), atol=0.01)
        np.testing.assert_array_equal(renderer.draw(**SEEN), wanted.draw(**SEEN))

    def test_come_and_go(self) -> None:
        for drawn_before in (False, True):
            with two() as both, lineatlas.Renderer(cube(), separate_objects=True, compute="cpp") as renderer:
                if drawn_before:
                    renderer.draw(**SEEN)
                self.assertEqual(renderer.add(self.other()), [1])
                self.expect_same(renderer, both)
                self.assertGreater(renderer.intervals(**SEEN)["edge"].max(), len(CUBE_POSITIONS))
                renderer.remove(0)
                both.hide([0])
                self.expect_same(renderer, both)
                both.hide([])
                self.assertEqual(renderer.add(cube()), [0])
                self.expect_same(renderer, both)
                found = renderer.pick(160, 120, **SEEN)
                self.assertIsNotNone(found)

    def test_stay_where_they_were_put(self) -> None:
        with two() as both, lineatlas.Renderer(cube(), separate_objects=True, compute="cpp") as renderer:
            up = np.eye(4)
            up[1, 3] = 0.5
            renderer.set_transforms([up])
            renderer.add(self.other())
            both.set_transforms([up, np.eye(4)])
            self.expect_same(renderer, both)

    def test_what_there_is_not(self) -> None:
        with two() as renderer:
            for number in (2, 1000):
                with self.assertRaises(lineatlas.UsageError):
                    renderer.remove(number)
            renderer.remove(1)
            with self.assertRaises(lineatlas.UsageError):
                renderer.remove(1)
            with self.assertRaises(lineatlas.UsageError):
                renderer.set_positions(two_cubes().positions)
            with self.assertRaises(TypeError):
                renderer.remove("all")


class Moving(unittest.TestCase):
    def test_transforms(self) -> None:
        aside = np.eye(4)
        aside[:3, 3] = (0.5, 0, 0)
        moved = lineatlas.Mesh(CUBE_POSITIONS + (0.5, 0, 0), CUBE_TRIANGLES)
        for drawn_before in (False, True):
            with lineatlas.Renderer(cube(), compute="cpp") as renderer, \
                    lineatlas.Renderer(moved, compute="cpp") as there:
                if drawn_before:
                    renderer.draw(**SEEN)
                renderer.set_transforms([aside])
                np.testing.assert_array_equal(renderer.draw(**SEEN), there.draw(**SEEN))
                self.assertEqual(renderer.frame().target, there.frame().target)
            with lineatlas.Renderer(cube()) as renderer, lineatlas.Renderer(moved) as there:
                renderer.set_transforms([aside])
                np.testing.assert_allclose(places(renderer.intervals(**SEEN)),
                                           places(there.intervals(**SEEN)), atol=0.01)

    def test_positions(self) -> None:
        bent = CUBE_POSITIONS + 0.3 * CUBE_POSITIONS[:, [1, 2, 0]]
        with lineatlas.Renderer(cube(), compute="cpp") as renderer, \
                lineatlas.Renderer(lineatlas.Mesh(bent, CUBE_TRIANGLES), compute="cpp") as there:
            renderer.set_positions(bent)
            np.testing.assert_allclose(places(renderer.intervals(**SEEN)), places(there.intervals(**SEEN)), atol=0.01)
            np.testing.assert_array_equal(renderer.draw(**SEEN), there.draw(**SEEN))
            renderer.set_positions(CUBE_POSITIONS)
            with lineatlas.Renderer(cube(), compute="cpp") as still:
                np.testing.assert_array_equal(renderer.draw(**SEEN), still.draw(**SEEN))

    def test_what_does_not_fit(self) -> None:
        with two() as renderer:
            before = places(renderer.intervals(**SEEN))
            with self.assertRaisesRegex(lineatlas.UsageError, r"shape \(n, 4, 4\)"):
                renderer.set_transforms(np.eye(4))
            with self.assertRaisesRegex(lineatlas.UsageError, "there are 2 objects, but 1 matri"):
                renderer.set_transforms([np.eye(4)])
            with self.assertRaisesRegex(lineatlas.UsageError, "singular"):
                renderer.set_transforms([np.eye(4), np.zeros((4, 4)) + np.diag([0, 0, 0, 1])])
            with self.assertRaisesRegex(lineatlas.UsageError, "has 8 rows, but the mesh has 16"):
                renderer.set_positions(CUBE_POSITIONS)
            np.testing.assert_array_equal(places(renderer.intervals(**SEEN)), before)
        with self.assertRaisesRegex(lineatlas.UsageError, "triangle_object has 1"):
            lineatlas.Mesh(CUBE_POSITIONS, CUBE_TRIANGLES, triangle_object=[0])

    def test_objects_of_a_mesh(self) -> None:
        mesh = two_cubes()
        np.testing.assert_array_equal(mesh.triangle_object, np.repeat([0, 1], 12))
        self.assertEqual(len(mesh.polyline_object), 0)


class Picking(unittest.TestCase):
    """Along -z, parallel: the corner (0, 0) is in the middle."""

    def setUp(self) -> None:
        self.view = lineatlas.View(eye=(0, 0, 8), target=(0, 0, 0), projection="orthographic")
        self.scale = SIZE[1] / self.view.shown_height
        self.at = {"size": SIZE, "view": self.view}

    def pixel(self, x: float, y: float) -> tuple:
        return SIZE[0] / 2 + self.scale * x, SIZE[1] / 2 - self.scale * y

    def check(self, renderer: lineatlas.Renderer) -> None:
        x, y = self.pixel(1, 0.4)
        found = renderer.pick(x + 2, y, **self.at)
        self.assertEqual(found.kind, lineatlas.LineKind.crease)
        self.assertAlmostEqual(found.distance, 2, 3)
        np.testing.assert_allclose(found.position, (x, y), atol=1e-3)
        np.testing.assert_allclose(found.world, (1, 0.4, 1), atol=1e-4)
        ends = CUBE_POSITIONS[found.edge]
        np.testing.assert_array_equal(ends[:, [0, 2]], 1)
        self.assertEqual(found.object, 0)
        self.assertIn("crease of object 0", repr(found))

        face = renderer.pick(*self.pixel(0.6, 0.3), **self.at)
        self.assertIsNone(face.kind)
        self.assertIsNone(face.edge)
        np.testing.assert_array_equal(CUBE_POSITIONS[CUBE_TRIANGLES[face.triangle]][:, 2], 1)
        np.testing.assert_allclose(face.world, (0.6, 0.3, 1), atol=1e-4)
        self.assertIsNone(renderer.pick(*self.pixel(-0.5, 0.3), **self.at))

    def test_without_and_with_pictures(self) -> None:
        with lineatlas.Renderer(cube(), compute="cpp") as renderer:
            self.check(renderer)
            renderer.draw(size=SIZE)
            self.check(renderer)

    def test_groups_and_objects(self) -> None:
        mesh = lineatlas.Mesh(CUBE_POSITIONS, CUBE_TRIANGLES, triangle_group=[1] * 12, groups=["a", "b"])
        with lineatlas.Renderer(mesh) as renderer:
            self.assertEqual(renderer.pick(*self.pixel(0.6, 0.3), **self.at).group, 1)
        with two() as renderer:
            self.assertEqual(renderer.pick(*self.pixel(2.4, 0.3), **self.at).object, 1)
            renderer.hide([1])
            self.assertIsNone(renderer.pick(*self.pixel(2.4, 0.3), **self.at))

    def test_refuses(self) -> None:
        with lineatlas.Renderer(cube()) as renderer:
            with self.assertRaises(lineatlas.UsageError):
                renderer.pick(1, 1, -1, **self.at)
            with self.assertRaises(lineatlas.UsageError):
                renderer.pick(float("nan"), 1, **self.at)
            with self.assertRaises(TypeError):
                renderer.pick("here", 1, **self.at)


class Progress(unittest.TestCase):
    def calls(self, progress: object) -> list:
        """Each as a function of nothing."""
        mesh = lineatlas.scene("clevis").mesh
        renderer = lineatlas.Renderer(mesh)
        self.addCleanup(renderer.close)
        return [lambda: lineatlas.Renderer(mesh, progress=progress).close(),
                lambda: renderer.set_model(mesh, progress=progress),
                lambda: renderer.intervals(progress=progress),
                lambda: renderer.to_svg(progress=progress),
                lambda: renderer.to_dxf(progress=progress),
                lambda: renderer.to_pdf(progress=progress),
                lambda: renderer.to_json(progress=progress),
                lambda: lineatlas.to_svg(mesh, progress=progress)]

    def test_is_told(self) -> None:
        told = []
        for call in self.calls(told.append):
            told.clear()
            call()
            self.assertEqual((told[0], told[-1]), (0, 1))
            self.assertEqual(told, sorted(told))
            self.assertGreater(len(told), 4)

    def test_stops(self) -> None:
        for call in self.calls(lambda done: done < 0.4):
            with self.assertRaises(lineatlas.Cancelled):
                call()
        self.assertTrue(issubclass(lineatlas.Cancelled, lineatlas.Error))

    def test_what_it_raises_comes_out(self) -> None:
        def fails(done: float) -> None:
            raise KeyError("told")

        for call in self.calls(fails):
            with self.assertRaisesRegex(KeyError, "told"):
                call()

    def test_control_c(self) -> None:
        """Without a callable too: the signal comes while the call works."""
        sent = []

        def interrupts(done: float) -> None:
            if done >= 0.3 and not sent:
                sent.append(done)
                os.kill(os.getpid(), signal.SIGINT)

        for call in self.calls(interrupts):
            sent.clear()
            with self.assertRaises(KeyboardInterrupt):
                call()

    def test_what_is_no_function(self) -> None:
        for call in self.calls(7):
            with self.assertRaisesRegex(TypeError, "progress must be a function"):
                call()


class ProgressOfFiles(unittest.TestCase):
    def test_load(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "strip.obj"
            path.write_text("".join(f"v {i} 0 0\nv {i} 1 0\n" for i in range(9000))
                            + "".join(f"f {i} {i + 1} {i + 2}\n" for i in range(1, 17000)))
            told = []
            lineatlas.load(path, progress=told.append)
            self.assertEqual((told[0], told[-1]), (0, 1))
            self.assertGreater(len(told), 4)
            with self.assertRaises(lineatlas.Cancelled):
                lineatlas.load(path, progress=lambda done: False)


if __name__ == "__main__":
    unittest.main()
