"""NumPy arrays in and out: every type and order, and clear errors for what is none of them."""

import unittest
import warnings

import numpy as np

import lineatlas
from support import CUBE_POSITIONS, CUBE_TRIANGLES, CUBE_VIEW, FolderTest, cube, dark_share


class In(unittest.TestCase):
    def check(self, positions: object, triangles: object) -> None:
        mesh = lineatlas.Mesh(positions, triangles)
        np.testing.assert_array_equal(mesh.positions, CUBE_POSITIONS)
        np.testing.assert_array_equal(mesh.triangles, CUBE_TRIANGLES)

    def test_types_and_orders(self) -> None:
        for real in (np.float16, np.float32, np.float64, np.int8, np.uint64, ">f8"):
            for whole in (np.int8, np.uint16, np.int32, np.int64, np.uint64, ">i4"):
                self.check(CUBE_POSITIONS.astype(real), CUBE_TRIANGLES.astype(whole))
        self.check(np.asfortranarray(CUBE_POSITIONS), np.asfortranarray(CUBE_TRIANGLES))
        wide = np.zeros((16, 6))
        wide[::2, ::2] = CUBE_POSITIONS
        self.check(wide[::2, ::2], CUBE_TRIANGLES[::-1][::-1])
        self.check(CUBE_POSITIONS.tolist(), CUBE_TRIANGLES.tolist())

    def test_views_are_not_copies_and_read_only(self) -> None:
        mesh = cube()
        positions = mesh.positions
        self.assertIs(positions.base, mesh)
        with self.assertRaises(ValueError):
            positions[0, 0] = 5
        del mesh
        np.testing.assert_array_equal(positions, CUBE_POSITIONS)  # the array keeps the mesh alive

    def test_given_arrays_may_change(self) -> None:
        positions = CUBE_POSITIONS.copy()
        mesh = lineatlas.Mesh(positions, CUBE_TRIANGLES)
        positions[:] = np.nan
        np.testing.assert_array_equal(mesh.positions, CUBE_POSITIONS)

    def test_soup(self) -> None:
        mesh = lineatlas.Mesh(CUBE_POSITIONS[CUBE_TRIANGLES].reshape(-1, 3))
        self.assertEqual(len(mesh.triangles), 12)
        np.testing.assert_array_equal(lineatlas.draw(mesh, size=(200, 200), view=CUBE_VIEW),
                                      lineatlas.draw(cube(), size=(200, 200), view=CUBE_VIEW))

    def test_groups(self) -> None:
        red = lineatlas.Group("box", "red", (1, 0, 0))
        mesh = cube(triangle_group=[0] * 6 + [1] * 6, groups=[red, "blue"])
        self.assertEqual([(g.object, g.material, g.color) for g in mesh.groups],
                         [("box", "red", (1, 0, 0)), ("", "blue", None)])
        mesh = cube(triangle_group=np.array([7] * 6 + [3_000_000_000] * 6))
        self.assertEqual([g.material for g in mesh.groups], ["7", "3000000000"])
        np.testing.assert_array_equal(mesh.triangle_group, [0] * 6 + [1] * 6)

    def test_polylines(self) -> None:
        mesh = lineatlas.Mesh(CUBE_POSITIONS, polylines=[[0, 7], np.array([[0, 0, 0], [1, 1, 0.]])])
        self.assertEqual(len(mesh.triangles), 0)
        self.assertEqual([line.tolist() for line in mesh.polylines], [[0, 7], [8, 9]])
        found = lineatlas.intervals(mesh, view=CUBE_VIEW)
        self.assertEqual(set(found["kind"]), {lineatlas.LineKind.file})
        self.assertTrue((found["triangle"] == -1).all())

    def test_empty(self) -> None:
        for mesh in (lineatlas.Mesh(np.zeros((0, 3)), np.zeros((0, 3), int)),
                     lineatlas.Mesh([], []), lineatlas.Mesh(CUBE_POSITIONS, [])):
            with self.assertWarnsRegex(UserWarning, "no triangles and no lines"):
                picture = lineatlas.draw(mesh, size=(50, 40), view=CUBE_VIEW)
            self.assertEqual(dark_share(picture), 0)
            self.assertEqual(len(lineatlas.intervals(mesh, view=CUBE_VIEW)), 0)
            with self.assertRaisesRegex(lineatlas.UsageError, "nothing to frame"):
                lineatlas.draw(mesh)
            with self.assertRaisesRegex(lineatlas.UsageError, "nothing to frame"):
                lineatlas.frame(mesh)

    def test_wrong_types(self) -> None:
        for positions in (CUBE_POSITIONS.astype(str), CUBE_POSITIONS.astype(complex),
                          np.full((8, 3), None), "abc", [[0, 1], [2]], None):
            with self.assertRaisesRegex(TypeError, "positions"):
                lineatlas.Mesh(positions, CUBE_TRIANGLES)
        for triangles in (CUBE_TRIANGLES.astype(float), CUBE_TRIANGLES.astype(bool), "abc"):
            with self.assertRaisesRegex(TypeError, "triangles"):
                lineatlas.Mesh(CUBE_POSITIONS, triangles)
        with self.assertRaises(TypeError):
            lineatlas.draw(17)

    def test_wrong_shapes(self) -> None:
        for positions in (np.zeros(24), np.zeros((8, 4)), np.zeros((2, 4, 3)), np.float32(1)):
            with self.assertRaisesRegex(lineatlas.UsageError, r"positions must have.*\(n, 3\)"):
                lineatlas.Mesh(positions, CUBE_TRIANGLES)
        with self.assertRaisesRegex(lineatlas.UsageError, r"triangles must have.*not \(12, 2\)"):
            lineatlas.Mesh(CUBE_POSITIONS, CUBE_TRIANGLES[:, :2])
        with self.assertRaisesRegex(lineatlas.UsageError, "8"):
            lineatlas.Mesh(CUBE_POSITIONS)
        with self.assertRaisesRegex(lineatlas.UsageError, "triangle_group has 5 entries"):
            cube(triangle_group=[0] * 5)
        with self.assertRaisesRegex(lineatlas.UsageError, "triangle_group"):
            cube(groups=["a"])

    def test_wrong_values(self) -> None:
        for value in (np.nan, np.inf, 1e300):
            positions = CUBE_POSITIONS.astype(float)
            positions[5, 1] = value
            with self.assertRaisesRegex(lineatlas.UsageError, "row 5"):
                lineatlas.Mesh(positions, CUBE_TRIANGLES)
        for index in (8, -1, 1 << 40, -(1 << 40), np.uint64(2**64 - 1)):
            triangles = CUBE_TRIANGLES.astype(np.uint64 if index > 8 else np.int64)
            triangles[3, 2] = index
            with self.assertRaisesRegex(lineatlas.UsageError, r"^triangles: entry 3 is -?\d+, not one of 0 to 7$"):
                lineatlas.Mesh(CUBE_POSITIONS, triangles)
        with self.assertRaisesRegex(lineatlas.UsageError, "^polylines: entry 1 is 8, not one of 0 to 7$"):
            lineatlas.Mesh(CUBE_POSITIONS, polylines=[[0, 8]])
        with self.assertRaisesRegex(lineatlas.UsageError, "^triangle_group: entry 2 is 1, not one of 0 to 0$"):
            cube(triangle_group=[0, 0, 1] + [0] * 9, groups=["a"])


class FarFromZero(FolderTest):
    """A cube of a metre where surveys have it: as at zero, about an origin, and as out of a file."""

    PLACES = [(5e5, 0, 5e6), (0, 0, 3e5), (-5e6, 2e6, 40)]

    def mesh_at(self, place: tuple, **arguments) -> lineatlas.Mesh:
        return lineatlas.Mesh(CUBE_POSITIONS.astype(float) + place, CUBE_TRIANGLES, **arguments)

    def view_at(self, mesh: lineatlas.Mesh, place: tuple) -> lineatlas.View:
        shift = np.subtract(place, mesh.origin)
        return lineatlas.View(CUBE_VIEW.eye + shift, CUBE_VIEW.target + shift)

    def test_lines_are_those_at_zero(self) -> None:
        near = lineatlas.intervals(cube(), size=(400, 300), view=CUBE_VIEW)
        self.assertEqual(tuple(cube().origin), (0, 0, 0))
        for place in self.PLACES:
            mesh = self.mesh_at(place)
            self.assertNotEqual(tuple(mesh.origin), (0, 0, 0))
            self.assertIn("far from zero", mesh.notes[0])
            view = self.view_at(mesh, place)
            found = lineatlas.intervals(mesh, size=(400, 300), view=view)
            self.assertEqual(len(found), len(near))
            np.testing.assert_allclose(found["p"], near["p"], atol=0.01)
            world = found["p_world"] + np.array(mesh.origin)
            np.testing.assert_allclose(world, near["p_world"] + np.array(place), atol=1e-4)
            with lineatlas.Renderer(mesh) as renderer:
                seen = renderer.pick(200, 150, radius=50, size=(400, 300), view=view)
                distance = np.add(seen.world, mesh.origin) - place
                self.assertTrue((distance > -0.01).all() and (distance < 1.01).all(), distance)

    def test_as_out_of_a_file(self) -> None:
        for place in self.PLACES:
            made = self.mesh_at(place)
            text = "".join(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in CUBE_POSITIONS.astype(float) + place)
            text += "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in CUBE_TRIANGLES)
            (self.folder / "cube.obj").write_text(text)
            read = lineatlas.load(self.folder / "cube.obj")
            self.assertEqual(tuple(made.origin), tuple(read.origin))
            np.testing.assert_array_equal(made.positions, read.positions)
            self.assertEqual(made.notes, read.notes)

    def test_lost_digits_are_said(self) -> None:
        with self.assertWarnsRegex(UserWarning, "float32.*steps of 0.5"):
            lineatlas.Mesh((CUBE_POSITIONS + np.array((0, 0, 5e6))).astype(np.float32), CUBE_TRIANGLES)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.mesh_at(self.PLACES[0])
            cube()

    def test_lines_alone(self) -> None:
        line = np.array([[0, 0, 0], [0.25, 0.5, 0.125]]) + np.array(self.PLACES[0])
        mesh = lineatlas.Mesh(np.zeros((0, 3)), polylines=[line])
        np.testing.assert_allclose(mesh.positions + np.array(mesh.origin), line, atol=1e-6)

    def test_parts_stand_beside_each_other(self) -> None:
        place = np.array(self.PLACES[0])
        first, second = self.mesh_at(place), self.mesh_at(place + (2, 0, 0))
        self.assertNotEqual(first.origin, second.origin)
        both = lineatlas.Mesh(np.concatenate([CUBE_POSITIONS + place, CUBE_POSITIONS + place + (2, 0, 0)]),
                              np.concatenate([CUBE_TRIANGLES, CUBE_TRIANGLES + 8]))
        shift = place - first.origin
        size, view = (400, 300), lineatlas.View(np.add((5, 4, 7), shift), np.add((1.5, 0.5, 0.5), shift))
        with lineatlas.Renderer(first, separate_objects=True) as renderer:
            renderer.add(second)
            added = renderer.intervals(size=size, view=view)
        moved = np.subtract(first.origin, both.origin)
        whole = lineatlas.intervals(both, size=size, view=lineatlas.View(view.eye + moved, view.target + moved))
        length = [float(np.linalg.norm(f["q"] - f["p"], axis=1).sum()) for f in (added, whole)]
        self.assertAlmostEqual(length[0], length[1], delta=0.5)

    def test_a_view_that_is_not_about_the_origin(self) -> None:
        mesh = self.mesh_at(self.PLACES[0])
        view = lineatlas.View(np.add(CUBE_VIEW.eye, self.PLACES[0]), np.add(CUBE_VIEW.target, self.PLACES[0]))
        with self.assertWarnsRegex(UserWarning, "about Mesh.origin"):
            lineatlas.Renderer(mesh).to_svg(size=(100, 80), view=view)


class Out(FolderTest):
    def test_picture_is_its_own(self) -> None:
        with lineatlas.Renderer(cube()) as renderer:
            first = renderer.draw(size=(64, 48), view=CUBE_VIEW)
            kept = first.copy()
            renderer.draw(size=(64, 48), view=lineatlas.View((-4, 3, 5), (0.5, 0.5, 0.5)))
        np.testing.assert_array_equal(first, kept)
        first[:] = 0  # the array may be written to

    def test_saved(self) -> None:
        picture = np.zeros((20, 30, 3), np.uint8)
        lineatlas.save(self.folder / "a.png", picture[::2, ::-1])
        self.assertTrue((self.folder / "a.png").read_bytes().startswith(b"\x89PNG"))
        for wrong in (picture.astype(float), picture[0], picture[:0], np.zeros((4, 4, 5), np.uint8)):
            with self.assertRaisesRegex(lineatlas.UsageError, "uint8"):
                lineatlas.save(self.folder / "b.png", wrong)
        with self.assertRaises(lineatlas.FileError):
            lineatlas.save(self.folder / "b.unknown", picture)
        with self.assertRaises(OSError):
            lineatlas.save(self.folder / "no" / "b.png", picture)


if __name__ == "__main__":
    unittest.main()
