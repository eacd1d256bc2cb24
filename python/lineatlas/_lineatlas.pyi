# Types of the compiled module; what its parts do is said by their docstrings.
import os
from types import TracebackType
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

_Triple = Tuple[float, float, float]
_Path = Union[str, "os.PathLike[str]"]
_Model = Union[Mesh, _Path]
_Vector = Union[Sequence[float], NDArray[Any]]
_Up = Union[str, _Vector]
_Size = Sequence[int]
_View = Union[View, Camera]
_Style = Union[Style, _Path]
_Kinds = Union[str, Sequence[str]]
_Progress = Callable[[float], Optional[bool]]

SCENES: Tuple[str, ...]
__version__: str

class Error(Exception): ...
class UsageError(Error, ValueError): ...
class FileError(Error, OSError): ...
class DeviceError(Error, RuntimeError): ...
class MismatchError(Error, RuntimeError): ...
class Cancelled(Error): ...

class Group:
    def __init__(
        self, object: str = "", material: str = "", color: Optional[_Vector] = None
    ) -> None: ...
    @property
    def object(self) -> str: ...
    @property
    def material(self) -> str: ...
    @property
    def color(self) -> Optional[_Triple]: ...

class Mesh:
    def __init__(
        self,
        positions: ArrayLike,
        triangles: Optional[ArrayLike] = None,
        *,
        triangle_group: Optional[ArrayLike] = None,
        groups: Optional[Sequence[Union[Group, str]]] = None,
        polylines: Iterable[ArrayLike] = (),
        known_edges: Optional[Mapping[str, ArrayLike]] = None,
        triangle_object: Optional[ArrayLike] = None,
        polyline_object: Optional[ArrayLike] = None,
    ) -> None: ...
    @property
    def positions(self) -> NDArray[np.float32]: ...
    @property
    def triangles(self) -> NDArray[np.uint32]: ...
    @property
    def triangle_group(self) -> NDArray[np.uint32]: ...
    @property
    def triangle_object(self) -> NDArray[np.uint32]: ...
    @property
    def polyline_object(self) -> NDArray[np.uint32]: ...
    @property
    def groups(self) -> list[Group]: ...
    @property
    def polylines(self) -> list[NDArray[np.uint32]]: ...
    @property
    def known_edges(self) -> dict[str, NDArray[np.uint32]]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def origin(self) -> list[float]: ...
    @property
    def volume(self) -> Optional[float]: ...
    def cut(
        self,
        planes: Union[str, list[str]],
        *,
        spacing: float = 0.0,
        angle: float = 45.0,
        hatching: bool = True,
        uncut: list[str] = [],
    ) -> Mesh: ...
    def exploded(
        self,
        factor: float = 1.5,
        *,
        moves: dict[str, Sequence[float]] = {},
        trails: bool = True,
    ) -> Mesh: ...

class Scene:
    @property
    def name(self) -> str: ...
    @property
    def mesh(self) -> Mesh: ...
    def view(self, t: float = 0.0) -> View: ...

class View:
    def __init__(
        self,
        eye: _Vector,
        target: _Vector,
        up: _Vector = (0.0, 1.0, 0.0),
        fov: float = 40.0,
        near: float = 0.0,
        far: float = 0.0,
        projection: str = "perspective",
    ) -> None: ...
    @property
    def eye(self) -> _Triple: ...
    @property
    def target(self) -> _Triple: ...
    @property
    def up(self) -> _Triple: ...
    @property
    def fov(self) -> float: ...
    @property
    def near(self) -> float: ...
    @property
    def far(self) -> float: ...
    @property
    def projection(self) -> str: ...
    @property
    def shown_height(self) -> float: ...

class Camera:
    def __init__(
        self, view: ArrayLike, projection: ArrayLike, *, zero_to_one: bool = False
    ) -> None: ...
    @property
    def view(self) -> NDArray[np.float32]: ...
    @property
    def projection(self) -> NDArray[np.float32]: ...

class Style:
    def __init__(self, base: Optional[_Path] = None, **kwargs: Any) -> None: ...
    def __getitem__(self, key: str) -> Any: ...
    def __setitem__(self, key: str, value: Any) -> None: ...
    def settings(self) -> dict[str, Any]: ...
    def to_toml(self, description: str = "") -> str: ...

class Options:
    def __init__(
        self,
        *,
        method: str = "auto",
        quality: str = "high",
        probes: Optional[int] = None,
        depth_scale: Optional[int] = None,
        step: float = 2.0,
        atlas: str = "auto",
        depth: str = "auto",
        strokes: str = "auto",
        steady: bool = False,
    ) -> None: ...

class Pick:
    @property
    def kind(self) -> Optional[int]: ...
    @property
    def segment(self) -> Optional[int]: ...
    @property
    def path(self) -> Optional[int]: ...
    @property
    def edge(self) -> Optional[list[int]]: ...
    @property
    def triangle(self) -> Optional[int]: ...
    @property
    def group(self) -> Optional[int]: ...
    @property
    def object(self) -> int: ...
    @property
    def position(self) -> Tuple[float, float]: ...
    @property
    def distance(self) -> float: ...
    @property
    def world(self) -> _Triple: ...

class Renderer:
    def __init__(
        self,
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
        one_picture: bool = False,
    ) -> None: ...
    def set_model(
        self,
        model: _Model,
        *,
        lines: Optional[_Kinds] = None,
        crease: Union[float, str] = "auto",
        silhouettes: Optional[str] = None,
        separate_objects: bool = False,
        progress: Optional[_Progress] = None,
    ) -> None: ...
    def set_transforms(self, world_from_object: ArrayLike) -> None: ...
    def set_positions(self, positions: ArrayLike) -> None: ...
    def hide(self, objects: ArrayLike) -> None: ...
    def add(self, model: _Model, *, progress: Optional[_Progress] = None) -> list[int]: ...
    def remove(self, object: int) -> None: ...
    @property
    def objects(self) -> list[str]: ...
    def pick(
        self,
        x: float,
        y: float,
        radius: float = 4.0,
        *,
        size: _Size = (1024, 768),
        view: Optional[_View] = None,
        up: _Up = "y",
    ) -> Optional[Pick]: ...
    def prepare(
        self,
        *,
        style: Optional[_Style] = None,
        options: Optional[Options] = None,
        progress: Optional[_Progress] = None,
    ) -> None: ...
    def draw(
        self,
        *,
        size: _Size = (1024, 768),
        view: Optional[_View] = None,
        up: _Up = "y",
        style: Optional[_Style] = None,
        options: Optional[Options] = None,
        transparent: bool = False,
    ) -> NDArray[np.uint8]: ...
    def intervals(
        self,
        *,
        size: _Size = (1024, 768),
        view: Optional[_View] = None,
        up: _Up = "y",
        options: Optional[Options] = None,
        hidden: bool = False,
        progress: Optional[_Progress] = None,
    ) -> NDArray[np.void]: ...
    def to_svg(
        self,
        *,
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
        progress: Optional[_Progress] = None,
    ) -> str: ...
    def to_dxf(
        self,
        *,
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
        progress: Optional[_Progress] = None,
    ) -> str: ...
    def to_pdf(
        self,
        *,
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
        progress: Optional[_Progress] = None,
    ) -> bytes: ...
    def to_json(
        self,
        *,
        size: _Size = (1024, 768),
        view: Optional[_View] = None,
        up: _Up = "y",
        style: Optional[_Style] = None,
        options: Optional[Options] = None,
        plotter: bool = False,
        tags: bool = True,
        progress: Optional[_Progress] = None,
    ) -> str: ...
    def to_sheet(
        self,
        *,
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
        progress: Optional[_Progress] = None,
    ) -> Union[str, bytes, NDArray[np.uint8]]: ...
    def frame(
        self,
        *,
        size: _Size = (1024, 768),
        up: _Up = "y",
        fov: float = 40.0,
        projection: str = "perspective",
        view: str | None = None,
    ) -> View: ...
    @property
    def description(self) -> str: ...
    def close(self) -> None: ...
    def __enter__(self) -> Renderer: ...
    def __exit__(
        self,
        *args: Union[type[BaseException], BaseException, TracebackType, None],
    ) -> None: ...

class Device:
    @property
    def name(self) -> str: ...
    @property
    def driver(self) -> str: ...
    @property
    def kind(self) -> str: ...

def load(
    path: _Path,
    *,
    deflection: float = 0.0,
    pixels: float = 1280.0,
    read_memory: float = 0.0,
    read_seconds: float = 0.0,
    progress: Optional[_Progress] = None,
) -> Mesh: ...
def scene(name: str) -> Scene: ...
def frame(
    model: _Model,
    *,
    size: _Size = (1024, 768),
    up: _Up = "y",
    fov: float = 40.0,
    projection: str = "perspective",
    view: str | None = None,
) -> View: ...
def turntable(
    model: _Model,
    frames: int,
    *,
    size: _Size = (1024, 768),
    up: _Up = "y",
    fov: float = 40.0,
    projection: str = "perspective",
    view: str | None = None,
) -> list[View]: ...
def camera_path(keys: Union[dict[int, View], dict[float, View]]) -> list[View]: ...
def styles() -> dict[str, str]: ...
def devices() -> list[Device]: ...
def save(
    path: _Path, picture: NDArray[np.uint8], *, dpi: float = 0.0, description: str = ""
) -> None: ...
