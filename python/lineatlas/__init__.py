"""Line drawings of 3D models: what is visible of their lines, as pictures and as arrays.

    import lineatlas

    picture = lineatlas.draw("model.obj", size=(1024, 768), style="pencil")
    lineatlas.save("picture.png", picture)

A Renderer draws many pictures of one model; the functions here make one for each call.
"""

from __future__ import annotations

import enum as _enum
import os as _os
import sys as _sys
from typing import Any as _Any
from typing import Union as _Union

try:
    import numpy as _numpy
except ImportError as _error:
    raise ImportError(
        f"lineatlas needs NumPy, which {_sys.executable} cannot import ({_error}): install it for "
        "that Python, or run the one that has it (Debian's is /usr/bin/python3)") from None

from ._lineatlas import (
    SCENES,
    Camera,
    Cancelled,
    Device,
    DeviceError,
    Error,
    FileError,
    Group,
    Mesh,
    MismatchError,
    Options,
    Pick,
    Renderer,
    Scene,
    Style,
    UsageError,
    View,
    __version__,
    camera_path,
    devices,
    frame,
    load,
    save,
    scene,
    styles,
    turntable,
)

__all__ = [
    "SCENES", "Camera", "Cancelled", "Device", "DeviceError", "Error", "FileError", "Group", "LineKind", "Mesh",
    "MismatchError", "Options", "Pick", "Renderer", "Scene", "Style", "UsageError", "View", "__version__",
    "camera_path", "devices", "draw", "frame", "intervals", "load", "save", "scene", "styles", "to_dxf", "to_json",
    "to_pdf", "to_sheet", "to_svg", "turntable",
]

_Model = _Union[Mesh, str, "_os.PathLike[str]"]
_OF_RENDERER = ("lines", "crease", "silhouettes", "separate_objects", "progress", "compute", "device", "interop")


class LineKind(_enum.IntEnum):
    """Where a line comes from: the field `kind` of intervals."""

    crease = 0
    boundary = 1
    material = 2
    silhouette = 3
    file = 4
    intersection = 5
    section = 6
    hatching = 7
    ridge = 8
    valley = 9
    tangent = 10
    centre = 11
    trail = 12


def _renderer(model: _Model, arguments: dict[str, _Any]) -> Renderer:
    """A renderer for one drawing of those arguments that are its own; they are taken out."""
    own = {name: arguments.pop(name) for name in _OF_RENDERER if name in arguments}
    return Renderer(model, one_picture=True, **own)


def draw(model: _Model, **arguments: _Any) -> _numpy.ndarray:
    """Draws a mesh, or that of a file, as a (height, width, 4) uint8 array.

    Arguments are those of Renderer() and Renderer.draw().
    """
    with _renderer(model, arguments) as renderer:
        return renderer.draw(**arguments)


def intervals(model: _Model, **arguments: _Any) -> _numpy.ndarray:
    """What is visible of the lines of a mesh, or that of a file, as a structured array.

    Arguments are those of Renderer() and Renderer.intervals(), which says what the fields are.
    """
    with _renderer(model, arguments) as renderer:
        return renderer.intervals(**arguments)


def to_svg(model: _Model, **arguments: _Any) -> str:
    """Draws a mesh, or that of a file, as SVG.

    Arguments are those of Renderer() and Renderer.to_svg().
    """
    with _renderer(model, arguments) as renderer:
        return renderer.to_svg(**arguments)


def to_dxf(model: _Model, **arguments: _Any) -> str:
    """Draws a mesh, or that of a file, as DXF.

    Arguments are those of Renderer() and Renderer.to_dxf().
    """
    with _renderer(model, arguments) as renderer:
        return renderer.to_dxf(**arguments)


def to_pdf(model: _Model, **arguments: _Any) -> bytes:
    """Draws a mesh, or that of a file, as PDF.

    Arguments are those of Renderer() and Renderer.to_pdf().
    """
    with _renderer(model, arguments) as renderer:
        return renderer.to_pdf(**arguments)


def to_json(model: _Model, **arguments: _Any) -> str:
    """Draws a mesh, or that of a file, as JSON paths (docs/vector.md).

    Arguments are those of Renderer() and Renderer.to_json().
    """
    with _renderer(model, arguments) as renderer:
        return renderer.to_json(**arguments)


def to_sheet(model: _Model, **arguments: _Any) -> _Union[str, bytes, _numpy.ndarray]:
    """Draws several views of a mesh, or that of a file, on one page.

    Arguments are those of Renderer() and Renderer.to_sheet().
    """
    with _renderer(model, arguments) as renderer:
        return renderer.to_sheet(**arguments)
