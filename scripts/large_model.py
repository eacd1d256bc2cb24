#!/usr/bin/env python3
"""Writes a large model as a binary PLY file: a hilly square with noise. Nearly every edge is a line.

usage: scripts/large_model.py FILE [SIDE]

SIDE squares along each side (1830: 6.7 million triangles, 10 million lines), two triangles each.
"""
import sys

import numpy as np

HEADER = """ply
format binary_little_endian 1.0
element vertex {vertices}
property float x
property float y
property float z
element face {faces}
property list uchar int vertex_indices
end_header
"""


def hills(side):
    """Positions of (side + 1) squared vertices, row by row."""
    along = np.linspace(-1, 1, side + 1)
    x, z = np.meshgrid(along, along)
    noise = np.random.default_rng(1).standard_normal(x.shape)
    y = 0.08 * np.sin(9 * x) * np.cos(7 * z) + 0.002 * noise
    return np.stack([x, y, z], axis=-1).reshape(-1, 3).astype("<f4")


def triangles(side):
    """Two triangles for every square of the grid."""
    row = np.arange(side)
    corner = (row[:, None] * (side + 1) + row[None, :]).ravel()
    above = corner + side + 1
    first = np.stack([corner, above, corner + 1], axis=-1)
    second = np.stack([corner + 1, above, above + 1], axis=-1)
    return np.concatenate([first, second])


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    side = int(sys.argv[2]) if len(sys.argv) == 3 else 1830
    vertices, corners = hills(side), triangles(side)
    faces = np.empty(len(corners), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, corners
    with open(sys.argv[1], "wb") as file:
        file.write(HEADER.format(vertices=len(vertices), faces=len(faces)).encode())
        file.write(vertices.tobytes())
        file.write(faces.tobytes())


main()
