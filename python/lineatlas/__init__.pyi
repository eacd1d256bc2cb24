import enum
from typing import Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from ._lineatlas import SCENES as SCENES
from ._lineatlas import Camera as Camera
from ._lineatlas import Cancelled as Cancelled
from ._lineatlas import Device as Device
from ._lineatlas import DeviceError as DeviceError
from ._lineatlas import Error as Error
from ._lineatlas import FileError as FileError
from ._lineatlas import Group as Group
from ._lineatlas import Mesh as Mesh
from ._lineatlas import MismatchError as MismatchError
from ._lineatlas import Options as Options
from ._lineatlas import Pick as Pick
from ._lineatlas import Renderer as Renderer
from ._lineatlas import Scene as Scene
from ._lineatlas import Style as Style
from ._lineatlas import UsageError as UsageError
from ._lineatlas import View as View
from ._lineatlas import __version__ as __version__
from ._lineatlas import _Kinds, _Model, _Progress, _Size, _Style, _Up, _View
from ._lineatlas import camera_path as camera_path
from ._lineatlas import devices as devices
from ._lineatlas import frame as frame
from ._lineatlas import load as load
from ._lineatlas import save as save
from ._lineatlas import scene as scene
from ._lineatlas import styles as styles
from ._lineatlas import turntable as turntable

__all__: list[str]

class LineKind(enum.IntEnum):
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

def draw(
    model: _Model,
    *,
    lines: Optional[_Kinds] = None,
    crease: Union[float, str] = "auto",
    silhouettes: Optional[str] = None,
    separate_objects: bool = False,
    progress: Optional[_Progress] = None,
    compute: str = "",
    device: str = "",
    interop: str = "",
    size: _Size = (1024, 768),
    view: Optional[_View] = None,
    up: _Up = "y",
    style: Optional[_Style] = None,
    options: Optional[Options] = None,
    transparent: bool = False,
) -> NDArray[np.uint8]: ...
def intervals(
    model: _Model,
    *,
    lines: Optional[_Kinds] = None,
    crease: Union[float, str] = "auto",
    silhouettes: Optional[str] = None,
    separate_objects: bool = False,
    progress: Optional[_Progress] = None,
    compute: str = "",
    device: str = "",
    interop: str = "",
    size: _Size = (1024, 768),
    view: Optional[_View] = None,
    up: _Up = "y",
    options: Optional[Options] = None,
    hidden: bool = False,
) -> NDArray[np.void]: ...
def to_svg(
    model: _Model,
    *,
    lines: Optional[_Kinds] = None,
    crease: Union[float, str] = "auto",
    silhouettes: Optional[str] = None,
    separate_objects: bool = False,
    progress: Optional[_Progress] = None,
    compute: str = "",
    device: str = "",
    interop: str = "",
    size: _Size = (1024, 768),
    view: Optional[_View] = None,
    up: _Up = "y",
    style: Optional[_Style] = None,
    options: Optional[Options] = None,
    page: Optional[str] = None,
    margin: str = "0",
    plotter: bool = False,
    tags: bool = True,
    transparent: bool = False,
    curves: bool = True,
    fit_arcs: bool = False,
    title: str = "Line drawing",
) -> str: ...
def to_dxf(
    model: _Model,
    *,
    lines: Optional[_Kinds] = None,
    crease: Union[float, str] = "auto",
    silhouettes: Optional[str] = None,
    separate_objects: bool = False,
    progress: Optional[_Progress] = None,
    compute: str = "",
    device: str = "",
    interop: str = "",
    size: _Size = (1024, 768),
    view: Optional[_View] = None,
    up: _Up = "y",
    style: Optional[_Style] = None,
    options: Optional[Options] = None,
    page: Optional[str] = None,
    margin: str = "0",
    plotter: bool = False,
    curves: bool = True,
    fit_arcs: bool = False,
) -> str: ...
def to_pdf(
    model: _Model,
    *,
    lines: Optional[_Kinds] = None,
    crease: Union[float, str] = "auto",
    silhouettes: Optional[str] = None,
    separate_objects: bool = False,
    progress: Optional[_Progress] = None,
    compute: str = "",
    device: str = "",
    interop: str = "",
    size: _Size = (1024, 768),
    view: Optional[_View] = None,
    up: _Up = "y",
    style: Optional[_Style] = None,
    options: Optional[Options] = None,
    page: Optional[str] = None,
    margin: str = "0",
    plotter: bool = False,
    transparent: bool = False,
    curves: bool = True,
    fit_arcs: bool = False,
    title: str = "Line drawing",
) -> bytes: ...
def to_json(
    model: _Model,
    *,
    lines: Optional[_Kinds] = None,
    crease: Union[float, str] = "auto",
    silhouettes: Optional[str] = None,
    separate_objects: bool = False,
    progress: Optional[_Progress] = None,
    compute: str = "",
    device: str = "",
    interop: str = "",
    size: _Size = (1024, 768),
    view: Optional[_View] = None,
    up: _Up = "y",
    style: Optional[_Style] = None,
    options: Optional[Options] = None,
    plotter: bool = False,
    tags: bool = True,
) -> str: ...
def to_sheet(
    model: _Model,
    *,
    lines: Optional[_Kinds] = None,
    crease: Union[float, str] = "auto",
    silhouettes: Optional[str] = None,
    separate_objects: bool = False,
    progress: Optional[_Progress] = None,
    compute: str = "",
    device: str = "",
    interop: str = "",
    type: str = "svg",
    views: Optional[str] = None,
    details: Sequence[str] = [],
    angle: Optional[str] = None,
    page: Optional[str] = None,
    scale: Optional[str] = None,
    unit: float = 1.0,
    up: _Up = "y",
    fields: Mapping[str, str] = {},
    measures: bool = False,
    style: Optional[_Style] = None,
    tags: bool = True,
    transparent: bool = False,
    curves: bool = True,
    fit_arcs: bool = False,
    dpi: float = 150.0,
) -> Union[str, bytes, NDArray[np.uint8]]: ...
