"""Blender's camera as the two matrices that lineatlas takes."""

from dataclasses import dataclass

import numpy as np

from .errors import DrawingError


@dataclass(frozen=True)
class Shot:
    """A camera and the picture that it makes."""

    world: np.ndarray  # (4, 4), eye to world
    projection: np.ndarray  # (4, 4), eye to clip space as in OpenGL
    size: tuple  # width and height in pixels

    def view(self, origin):
        """World to eye space for positions that `origin` is taken off."""
        moved = self.world.copy()
        moved[:3, 3] -= origin
        return np.linalg.inv(moved)


def check(scene):
    """Raises what stands in the way of a camera before anything is drawn."""
    camera = scene.camera
    if camera is None:
        raise DrawingError(f"the scene \"{scene.name}\" has no camera: add one, or choose it in the scene's properties")
    if camera.type != "CAMERA":
        raise DrawingError(f"the scene's camera \"{camera.name}\" is no camera but a {camera.type.lower()}")
    if camera.data.type == "PANO":
        raise DrawingError(f"the camera \"{camera.name}\" is panoramic: lines stay straight only in "
                           "perspective and orthographic views")


def size_of(render):
    return tuple(side * render.resolution_percentage // 100
                 for side in (render.resolution_x, render.resolution_y))


def cropped(projection, size, render):
    """What is left of the picture if it is cropped to the render border."""
    if not (render.use_border and render.use_crop_to_border):
        return projection, size
    low = [int(share * side) for share, side in zip((render.border_min_x, render.border_min_y), size)]
    high = [int(share * side) for share, side in zip((render.border_max_x, render.border_max_y), size)]
    window = np.eye(4)
    for axis in range(2):
        # From -1..1 over the whole picture to -1..1 over its part.
        window[axis, axis] = size[axis] / (high[axis] - low[axis])
        window[axis, 3] = (size[axis] - high[axis] - low[axis]) / (high[axis] - low[axis])
    return window @ projection, (high[0] - low[0], high[1] - low[1])


def shot_of(scene, depsgraph):
    """The scene's camera as it stands in the frame of the depsgraph, with shift and clipping."""
    render, camera = scene.render, scene.camera.evaluated_get(depsgraph)
    size = size_of(render)
    projection = camera.calc_matrix_camera(depsgraph, x=size[0], y=size[1], scale_x=render.pixel_aspect_x,
                                           scale_y=render.pixel_aspect_y)
    # Blender's cameras have no scale.
    world = np.array(camera.matrix_world.normalized(), dtype=float)
    projection, size = cropped(np.array(projection, dtype=float), size, render)
    return Shot(world, projection, size)
