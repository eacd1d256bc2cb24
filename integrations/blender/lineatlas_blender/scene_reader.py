"""What a frame shows, as arrays: evaluated meshes, instances, materials, marks."""

from dataclasses import dataclass, field

import numpy as np

from . import geometry
from .parts import Names, materials_of

SHAPES = {"MESH", "CURVE", "SURFACE", "FONT", "META", "CURVES", "POINTCLOUD", "VOLUME"}


@dataclass
class SceneArrays:
    """Triangles and lines of all instances, in the world less `origin`."""

    positions: np.ndarray
    triangles: np.ndarray
    triangle_group: np.ndarray
    groups: list  # (part, material, colour or None)
    marked: np.ndarray
    loose: np.ndarray
    origin: np.ndarray
    notes: list = field(default_factory=list)

    def empty(self):
        return len(self.triangles) == 0 and len(self.loose) == 0

    def same_shape(self, other):
        """Whether lines found in one are those of the other."""
        return self.groups == other.groups and all(
            np.array_equal(getattr(self, name), getattr(other, name))
            for name in ("positions", "triangles", "triangle_group", "marked", "loose", "origin"))


class Reader:
    """Puts instances together."""

    def __init__(self, scene):
        self.names = Names(scene)
        self.shapes, self.notes, self.groups = {}, [], []
        self.tables = {name: [] for name in ("positions", "triangles", "triangle_group", "marked", "loose")}
        self.count = 0

    def geometry_of(self, item):
        # Instances made by geometry nodes share a temporary object: its data tell them apart.
        key = item.as_pointer(), item.data.as_pointer() if item.data else 0
        if key not in self.shapes:
            mesh = item.to_mesh() if item.type != "VOLUME" else None
            self.shapes[key] = geometry.read(mesh, item.type == "MESH") if mesh else None
            item.to_mesh_clear()
            self.note(item, self.shapes[key])
        return self.shapes[key]

    def note(self, item, shape):
        if item.type != "MESH" or shape is None or len(shape.triangles):
            return
        rest = f"only its {len(shape.loose)} loose edges are drawn" if len(shape.loose) else "nothing of it is drawn"
        self.notes.append(f"the mesh of \"{item.name}\" has no faces: {rest}")

    def add(self, instance):
        item = instance.object
        if item.type not in SHAPES or not instance.show_self or not getattr(item, "visible_camera", True):
            return
        shape = self.geometry_of(item)
        if shape is None or (len(shape.triangles) == 0 and len(shape.loose) == 0):
            return
        matrix = np.array(instance.matrix_world, float)
        triangles = shape.triangles
        if np.linalg.det(matrix[:3, :3]) < 0:
            triangles = triangles[:, ::-1]  # a mirror turns faces round
        slots = materials_of(item)
        part = self.names.part(instance)
        self.tables["positions"].append(shape.positions @ matrix[:3, :3].T + matrix[:3, 3])
        self.tables["triangles"].append(triangles + self.count)
        self.tables["triangle_group"].append(np.minimum(shape.slots, len(slots) - 1) + len(self.groups))
        self.tables["marked"].append(shape.marked + self.count)
        self.tables["loose"].append(shape.loose + self.count)
        self.groups += [(part, name, color) for name, color in slots]
        self.count += len(shape.positions)

    def arrays(self):
        width = {"triangle_group": ()}
        tables = {name: np.concatenate(parts) if parts else np.zeros((0, *width.get(name, (3,))), int)
                  for name, parts in self.tables.items()}
        positions, origin = near_zero(tables.pop("positions").astype(float))
        return SceneArrays(positions=positions, groups=self.groups, origin=origin, notes=self.notes, **tables)


def near_zero(positions):
    """Positions as 32-bit floats hold them: far from zero, compared with their size, they are moved there."""
    if len(positions):
        low, high = positions.min(axis=0), positions.max(axis=0)
        middle = (low + high) / 2
        if np.abs(middle).max() > 100 * np.linalg.norm(high - low):
            return positions - middle, middle
    return positions, np.zeros(3)


def read(scene, depsgraph):
    """All that the depsgraph, that of a render, shows of the scene."""
    reader = Reader(scene)
    for instance in depsgraph.object_instances:
        reader.add(instance)
    return reader.arrays()
