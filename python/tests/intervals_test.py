"""Intervals of what one can work out by hand, and of a scene beside the tool's JSON."""

import json
import unittest

import numpy as np

import lineatlas
from support import CUBE_POSITIONS, CUBE_VIEW, FolderTest, cube, run_tool


def project(points: np.ndarray, size: tuple) -> np.ndarray:
    """Where CUBE_VIEW sees them: pixels from the upper left corner."""
    eye, target = np.array(CUBE_VIEW.eye), np.array(CUBE_VIEW.target)
    forward = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(forward, CUBE_VIEW.up)
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    away = points - eye
    scale = size[1] / 2 / np.tan(np.radians(CUBE_VIEW.fov) / 2) / (away @ forward)
    return np.stack([size[0] / 2 + away @ right * scale, size[1] / 2 - away @ up * scale], axis=-1)


class OfACube(unittest.TestCase):
    size = (800, 600)

    def find(self, **arguments) -> np.ndarray:
        return lineatlas.intervals(cube(), size=self.size, view=CUBE_VIEW, **arguments)

    def find_edges(self) -> np.ndarray:
        """Without the ends of hidden edges, of which half of a probe's pixel peeps out."""
        found = self.find()
        self.assertTrue(found["visible"].all())
        lengths = np.linalg.norm(found["q_world"] - found["p_world"], axis=1)
        self.assertLess(lengths[lengths < 0.9].sum(), 0.02)
        np.testing.assert_allclose(lengths[lengths >= 0.9], 1, atol=0.01)
        return found[lengths >= 0.9]

    def test_nine_edges_are_visible_whole(self) -> None:
        found = self.find_edges()
        self.assertEqual(set(found["kind"]), {lineatlas.LineKind.crease})
        edges = {tuple(sorted(edge)) for edge in found["edge"]}
        self.assertEqual(len(found), 9)
        self.assertEqual(len(edges), 9)
        self.assertFalse(any(0 in edge for edge in edges))  # 0 is the corner on the far side

    def test_pixels_depth_and_sources(self) -> None:
        found = self.find_edges()
        for end in ("p", "q"):
            np.testing.assert_allclose(found[end], project(found[end + "_world"], self.size),
                                       atol=0.02)
            self.assertTrue(((found[end + "_depth"] > 0) & (found[end + "_depth"] < 1)).all())
        ends = CUBE_POSITIONS[found["edge"]]
        np.testing.assert_allclose(found["p_world"], ends[:, 0], atol=0.01)
        np.testing.assert_allclose(found["q_world"], ends[:, 1], atol=0.01)
        corners = cube().triangles[found["triangle"]]
        for edge, triangle in zip(found["edge"], corners):
            self.assertLessEqual(set(edge), set(triangle))

    def test_hidden_ones_are_the_other_three(self) -> None:
        found = self.find(hidden=True)
        hidden = found[~found["visible"]]
        hidden_length = np.linalg.norm(hidden["q_world"] - hidden["p_world"], axis=1).sum()
        self.assertAlmostEqual(float(hidden_length), 3, delta=0.05)
        self.assertTrue((hidden["edge"] == 0).any(axis=1).sum() >= 3)

    def test_kinds_and_groups(self) -> None:
        self.assertEqual(len(self.find(lines="silhouette,boundary", crease=120)), 6)
        self.assertEqual(len(self.find(lines=["file"])), 0)
        with self.assertRaisesRegex(lineatlas.UsageError, "there is no line kind"):
            self.find(lines="creases")
        for crease in (np.nan, np.inf, -1, 1e30):
            with self.assertRaisesRegex(lineatlas.UsageError, "crease must be from 0 to 180"):
                self.find(crease=crease)
        mesh = cube(triangle_group=[0] * 4 + [1] * 8, groups=["a", "b"])
        found = lineatlas.intervals(mesh, size=self.size, view=CUBE_VIEW)
        self.assertEqual({lineatlas.LineKind.crease}, set(found["kind"]))  # sharp edges, whatever the colours
        np.testing.assert_array_equal(found["group"], mesh.triangle_group[found["triangle"]])

    def test_only_by_the_atlas(self) -> None:
        with self.assertRaisesRegex(lineatlas.UsageError, "atlas"):
            self.find(options=lineatlas.Options(method="spine"))
        with self.assertRaisesRegex(lineatlas.UsageError, "probes"):
            self.find(options=lineatlas.Options(probes=5))


class OfAScene(FolderTest):
    def test_as_the_tool(self) -> None:
        """Each interval lies on the path of the tool's JSON that has its segment."""
        path = self.folder / "clevis.json"
        run_tool("draw", "--scene", "clevis", "-o", path)
        drawing = json.loads(path.read_text())
        scene = lineatlas.scene("clevis")
        found = lineatlas.intervals(scene.mesh, view=scene.view(0))
        drawn = sum(np.linalg.norm(np.diff(np.array(p["points"])[:, :2], axis=0), axis=1).sum()
                    for p in drawing["paths"])
        length = np.linalg.norm(found["q"] - found["p"], axis=1).sum()
        self.assertGreater(drawn, 1000)
        self.assertAlmostEqual(length / drawn, 1, delta=0.02)  # paths close gaps and drop repeats


if __name__ == "__main__":
    unittest.main()
