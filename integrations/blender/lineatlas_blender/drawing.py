"""The lines of a frame: found once, given as paths, as SVG and as a picture."""

import json
import threading
import warnings

import numpy as np

from . import library
from .errors import DrawingError


class Lines:
    """Which lines there are and how they look; None: as lineatlas has it."""

    def __init__(self, kinds=None, crease=None, style=None, width=None, color=None, hidden=False):
        self.kinds, self.crease, self.style = kinds, crease, style
        self.width, self.color, self.hidden = width, color, hidden

    def found_like(self, other):
        return (self.kinds, self.crease) == (other.kinds, other.crease)

    def style_of(self, lineatlas):
        style = lineatlas.Style(self.style)
        if self.width is not None:
            style["width"] = self.width
        if self.color is not None:
            style["color"] = "#" + "".join(f"{round(255 * min(max(v, 0), 1)):02x}" for v in self.color)
        style["hidden"] = self.hidden
        return style


def mesh_of(lineatlas, arrays):
    groups = [lineatlas.Group(object=part, material=material, color=color)
              for part, material, color in arrays.groups]
    more = {"triangle_group": arrays.triangle_group, "groups": groups} if len(arrays.triangles) else {}
    if len(arrays.marked):
        more["known_edges"] = {"marked": arrays.marked}
    return lineatlas.Mesh(arrays.positions, arrays.triangles, polylines=list(arrays.loose), **more)


def elsewhere(work):
    """The result of `work` on a thread of its own: once a picture was drawn, every call of the renderer makes its
    OpenGL context current, and Blender's, made by GLX, must stay so on this thread."""
    result, failure = [], []

    def run():
        try:
            result.append(work())
        except Exception as error:
            failure.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    if failure:
        raise failure[0]
    return result[0]


class Drawer:
    """Draws frame after frame; while only the camera moves, lines are found once."""

    def __init__(self, lines):
        self.lineatlas, self.lines = library.load(), lines
        self.arrays, self.renderer, self.frame = None, None, None

    def show(self, frame):
        """The frame that is drawn from now on."""
        if frame.arrays.empty():
            notes = "; ".join(frame.arrays.notes[:1])
            raise DrawingError("there is nothing to draw: no mesh that renders see"
                               + (f" ({notes})" if notes else " in this view layer"))
        if self.arrays is None or not self.arrays.same_shape(frame.arrays):
            mesh, crease = mesh_of(self.lineatlas, frame.arrays), self.lines.crease
            found = {"lines": self.lines.kinds, "crease": "auto" if crease is None else crease}
            if self.renderer is None:
                self.renderer = self.lineatlas.Renderer(mesh, **found)
            else:
                elsewhere(lambda: self.renderer.set_model(mesh, **found))
        self.arrays, self.frame = frame.arrays, frame
        shot = frame.shot
        self.view = {"size": shot.size,
                     "view": self.lineatlas.Camera(shot.view(frame.arrays.origin), shot.projection)}

    def draw(self, method, **more):
        """One of the renderer's ways to draw; a blank drawing is none that Blender should warn of by a traceback."""
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            style = self.lines.style_of(self.lineatlas)
            drawn = elsewhere(lambda: getattr(self.renderer, method)(style=style, **self.view, **more))
        return drawn, [str(one.message) for one in said]

    def svg(self):
        """The drawing as SVG and what there is to say of it."""
        return self.draw("to_svg", transparent=True, title=f"Frame {self.frame.number}")

    def picture(self):
        """(height, width, 4) bytes, transparent where there is no line. Needs OpenGL."""
        try:
            return self.draw("draw", transparent=True)
        except self.lineatlas.DeviceError as error:
            raise DrawingError(f"a picture of the lines needs OpenGL ({error}); SVG and Grease Pencil do not") from None

    def paths(self):
        """Joined lines: dictionaries with `kind`, `visible`, `closed`, `points`, and `world` in the scene's units."""
        text, notes = self.draw("to_json", tags=False)
        paths = json.loads(text)["paths"]
        for path in paths:
            path["world"] = np.array(path["world"], float) + self.arrays.origin
        return paths, notes

    def intervals(self, hidden=False):
        """As lineatlas.intervals(), of the frame; world positions less frame.arrays.origin."""
        return elsewhere(lambda: self.renderer.intervals(hidden=hidden, **self.view))

    def close(self):
        if self.renderer is not None:
            elsewhere(self.renderer.close)
