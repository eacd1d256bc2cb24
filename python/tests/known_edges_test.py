"""What is known of edges, in place of their angles."""

import unittest

import numpy as np
from support import cube

import lineatlas

# A sheet of four flat triangles about its middle.
SHEET = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], float)
FAN = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]])
VIEW = lineatlas.View(eye=(1, 2, 4), target=(0, 0, 0))


def creases(mesh: lineatlas.Mesh) -> set:
    found = lineatlas.intervals(mesh, view=VIEW, hidden=True)
    found = found[found["kind"] == lineatlas.LineKind.crease]
    return {tuple(sorted(edge)) for edge in found["edge"].tolist()}


class KnownEdges(unittest.TestCase):
    def test_marked_ones_are_creases_however_flat(self) -> None:
        self.assertEqual(creases(lineatlas.Mesh(SHEET, FAN)), set())
        mesh = lineatlas.Mesh(SHEET, FAN, known_edges={"marked": [[2, 0], [0, 4]]})
        self.assertEqual(creases(mesh), {(0, 2), (0, 4)})
        np.testing.assert_array_equal(mesh.known_edges["marked"], [[2, 0], [0, 4]])

    def test_marks_leave_others_to_angles_and_faces_do_not(self) -> None:
        twelve = creases(cube())
        self.assertEqual(len(twelve), 12)
        self.assertEqual(creases(cube(known_edges={"marked": [[0, 3]]})), twelve | {(0, 3)})
        self.assertEqual(creases(cube(known_edges={"sharp": [[0, 1]], "seam": [[1, 3]]})), {(0, 1)})

    def test_what_does_not_fit_is_refused(self) -> None:
        for edges, error, said in (
                ({"bent": [[0, 1]]}, lineatlas.UsageError, 'no kind "bent"; there is sharp, smooth, seam, free, wire, marked'),
                ({"marked": [[0, 8]]}, lineatlas.UsageError, "known_edges: entry 0 is 8, not one of 0 to 7"),
                ({"marked": [0, 1]}, lineatlas.UsageError, r"known_edges must have the shape \(n, 2\), not \(2\)"),
                ({"marked": [[0.5, 1]]}, TypeError, "known_edges must be whole numbers"),
                ([[0, 1]], TypeError, "known_edges")):
            with self.assertRaisesRegex(error, said):
                cube(known_edges=edges)

    def test_none_are_known(self) -> None:
        self.assertEqual(cube().known_edges, {})
        self.assertEqual(cube(known_edges={"marked": np.zeros((0, 2), int)}).known_edges, {})


if __name__ == "__main__":
    unittest.main()
