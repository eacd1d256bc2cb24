"""Scenes and measures that several tests use."""

import math
import pathlib
import tempfile
import unittest

import bpy
import numpy as np
from mathutils import Vector


class SceneTest(unittest.TestCase):
    """Starts with an empty scene and a folder for what is rendered."""

    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        import addon_utils

        addon_utils.enable("lineatlas_blender", default_set=True)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.scene = bpy.context.scene
        render = self.scene.render
        render.resolution_x, render.resolution_y, render.resolution_percentage = 320, 240, 100
        render.filepath = str(self.folder / "render_")
        render.film_transparent = True
        render.engine = "CYCLES"
        self.scene.cycles.samples, self.scene.cycles.use_denoising = 64, False
        self.scene.cycles.pixel_filter_type = "BOX"
        self.scene.view_settings.view_transform = "Standard"

    def camera(self, place, target=(0, 0, 0), **settings):
        data = bpy.data.cameras.new("camera")
        for name, value in settings.items():
            setattr(data, name, value)
        camera = bpy.data.objects.new("camera", data)
        camera.location = place
        camera.rotation_euler = (Vector(target) - Vector(place)).to_track_quat("-Z", "Y").to_euler()
        self.scene.collection.objects.link(camera)
        self.scene.camera = camera
        return camera

    def mesh(self, name, positions, faces, edges=(), collection=None):
        data = bpy.data.meshes.new(name)
        data.from_pydata(positions, edges, faces)
        item = bpy.data.objects.new(name, data)
        (collection or self.scene.collection).objects.link(item)
        return item

    def wedge(self, name="wedge", collection=None):
        """Without symmetry: a mirrored one is another."""
        low = [(-1, -1, -1), (1.4, -1, -1), (1, 1, -1), (-1, 0.6, -1)]
        corners = low + [(x + 0.5, y + 0.3, 1.2) for x, y, _ in low]
        sides = [(i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i in range(4)]
        faces = [(3, 2, 1, 0), (4, 5, 6, 7)] + sides
        return self.mesh(name, corners, faces, collection=collection)

    def rendered(self):
        """The render as (height, width, 4) floats, rows from the top."""
        path = self.folder / "rendered.exr"
        settings = self.scene.render.image_settings
        settings.file_format, settings.color_mode, settings.color_depth = "OPEN_EXR", "RGBA", "32"
        before, self.scene.render.filepath = self.scene.render.filepath, str(path)
        bpy.ops.render.render(write_still=True)
        self.scene.render.filepath = before
        settings.file_format = "PNG"
        return pixels_of(path)


def pixels_of(path):
    """A picture as (height, width, 4) floats, rows from the top."""
    image = bpy.data.images.load(str(path))
    width, height = image.size
    values = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(values)
    bpy.data.images.remove(image)
    return values.reshape(height, width, 4)[::-1]


def outline(alpha):
    """Where coverage passes one half between neighbouring pixels, in pixels from the upper left corner."""
    points = []
    for axis in (0, 1):
        a, b = (alpha[:-1], alpha[1:]) if axis == 0 else (alpha[:, :-1], alpha[:, 1:])
        rows, columns = np.nonzero((a < 0.5) != (b < 0.5))
        share = (0.5 - a[rows, columns]) / (b[rows, columns] - a[rows, columns])
        if axis == 0:
            points.append(np.stack([columns + 0.5, rows + 0.5 + share], axis=1))
        else:
            points.append(np.stack([columns + 0.5 + share, rows + 0.5], axis=1))
    return np.concatenate(points)


def distances(points, p, q):
    """Of each point to the nearest of the segments from p to q."""
    along = q - p
    square = np.maximum((along ** 2).sum(axis=1), 1e-12)
    nearest = np.full(len(points), math.inf)
    for start in range(0, len(points), 256):
        some = points[start:start + 256, None, :]
        share = np.clip(((some - p) * along).sum(axis=2) / square, 0, 1)[..., None]
        nearest[start:start + 256] = np.linalg.norm(some - p - share * along, axis=2).min(axis=1)
    return nearest


def strays(alpha, p, q):
    """Points of the segments within the picture none of whose four nearest pixels is covered at all."""
    count = int(np.linalg.norm(q - p, axis=1).max()) + 2
    share = np.linspace(0, 1, count)[:, None, None]
    points = (p + share * (q - p)).reshape(-1, 2)
    height, width = alpha.shape
    inside = (points > 0.5).all(axis=1) & (points[:, 0] < width - 0.5) & (points[:, 1] < height - 0.5)
    points = points[inside]
    column, row = np.floor(points - 0.5).astype(int).T
    most = np.max([alpha[row + below, column + right] for below in (0, 1) for right in (0, 1)], axis=0)
    return points[most == 0]
