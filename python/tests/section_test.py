"""Meshes that are cut by planes, and parts that stand apart."""

import unittest

import numpy as np

import lineatlas
from support import cube


class Sections(unittest.TestCase):
    def test_half_a_cube(self) -> None:
        mesh = cube()
        low, high = mesh.positions.min(axis=0), mesh.positions.max(axis=0)
        half = mesh.cut("x=50%", spacing=0.1)
        used = half.positions[half.triangles]
        self.assertAlmostEqual(float(used[..., 0].max()), float(low[0] + high[0]) / 2, 6)
        self.assertAlmostEqual(float(used[..., 1].max()), float(high[1]), 6)
        self.assertGreater(len(half.polylines), 10)
        np.testing.assert_array_equal(half.positions[:len(mesh.positions)], mesh.positions)
        other = mesh.cut("-x=50%", hatching=False)
        self.assertEqual(len(other.polylines), 1)
        kinds = set(lineatlas.intervals(half, compute="cpp", hidden=True)["kind"])
        self.assertIn(lineatlas.LineKind.section, kinds)
        self.assertIn(lineatlas.LineKind.hatching, kinds)

    def test_uncut_parts(self) -> None:
        one = cube()
        mesh = lineatlas.Mesh(np.concatenate([one.positions, one.positions + (10, 0, 0)]),
                              np.concatenate([one.triangles, one.triangles + len(one.positions)]),
                              triangle_group=np.repeat([0, 1], len(one.triangles)),
                              groups=[lineatlas.Group("left"), lineatlas.Group("Bolt 1")])
        middle = float(one.positions[:, 1].min() + one.positions[:, 1].max()) / 2
        rest = mesh.cut("y=50%", uncut=["Bolt*"])
        used = rest.positions[rest.triangles].reshape(-1, 3)
        right = used[:, 0] > float(one.positions[:, 0].max()) + 1
        self.assertAlmostEqual(float(used[~right, 1].max()), middle, 5)
        self.assertAlmostEqual(float(used[right, 1].max()), float(one.positions[:, 1].max()), 5)
        with self.assertRaises(lineatlas.UsageError):
            mesh.cut("y=50%", uncut=["Nut"])
        with self.assertRaises(TypeError):
            mesh.cut("y=50%", uncut="Nut")

    def test_several_planes_and_what_is_wrong(self) -> None:
        mesh = cube()
        self.assertEqual(mesh.cut(["x=50%", "y=50%"]).notes, [])
        for planes in ("x=1000", "w=1", ["x=50%"] * 7):
            with self.assertRaises(lineatlas.UsageError):
                mesh.cut(planes)
        with self.assertRaises(TypeError):
            mesh.cut(3)

    def test_parts_apart(self) -> None:
        mesh = lineatlas.Mesh(np.concatenate([cube().positions, cube().positions + (10, 0, 0)]),
                              np.concatenate([cube().triangles, cube().triangles + len(cube().positions)]),
                              triangle_group=np.repeat([0, 1], len(cube().triangles)),
                              groups=[lineatlas.Group("left"), lineatlas.Group("right")])
        apart = mesh.exploded(2)
        moved = apart.positions[:len(mesh.positions)] - mesh.positions
        np.testing.assert_allclose(moved[0], (-5, 0, 0), atol=1e-5)
        np.testing.assert_allclose(moved[-1], (5, 0, 0), atol=1e-5)
        self.assertEqual(len(apart.polylines), 2)
        kinds = set(lineatlas.intervals(apart, compute="cpp", hidden=True)["kind"])
        self.assertIn(lineatlas.LineKind.trail, kinds)
        up = mesh.exploded(1, moves={"r*": (0, 3, 0)}, trails=False)
        np.testing.assert_allclose((up.positions - mesh.positions)[-1], (0, 3, 0), atol=1e-5)
        self.assertEqual(len(up.polylines), 0)
        for wrong in ({"factor": 0.5}, {"moves": {"nobody": (1, 0, 0)}}):
            with self.assertRaises(lineatlas.UsageError):
                mesh.exploded(**wrong)


if __name__ == "__main__":
    unittest.main()
