"""An evaluated object's own mesh as arrays."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Geometry:
    """What instances share: no transform, no names."""

    positions: np.ndarray  # (n, 3) float
    triangles: np.ndarray  # (m, 3) indices
    slots: np.ndarray  # (m,) material slots
    marked: np.ndarray  # (k, 2) edges that have a Freestyle mark
    loose: np.ndarray  # (l, 2) edges of no face


def values(collection, name, kind, width=1):
    """One property of all elements of a Blender collection."""
    flat = np.empty(len(collection) * width, kind)
    collection.foreach_get(name, flat)
    return flat.reshape(-1, width) if width > 1 else flat


def marks_of(mesh):
    if not mesh.edges:
        return np.zeros(0, bool)
    if hasattr(mesh.edges[0], "use_freestyle_mark"):
        return values(mesh.edges, "use_freestyle_mark", bool)
    attribute = mesh.attributes.get("freestyle_edge")  # where newer versions keep it
    return values(attribute.data, "value", bool) if attribute else np.zeros(len(mesh.edges), bool)


def read(mesh, wire):
    """Arrays of a mesh; with `wire` its loose edges, too."""
    mesh.calc_loop_triangles()
    edges = values(mesh.edges, "vertices", np.int32, 2).reshape(-1, 2)
    of_faces = np.zeros(len(edges), bool)
    of_faces[values(mesh.loops, "edge_index", np.int32)] = True
    marked = marks_of(mesh) & of_faces
    return Geometry(positions=values(mesh.vertices, "co", np.float32, 3).reshape(-1, 3).astype(float),
                    triangles=values(mesh.loop_triangles, "vertices", np.int32, 3).reshape(-1, 3),
                    slots=values(mesh.loop_triangles, "material_index", np.int32),
                    marked=edges[marked],
                    loose=edges[~of_faces] if wire else edges[:0])
