"""What several tests use."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import zlib

import numpy as np

import lineatlas

TOOL = os.environ.get("LINEATLAS_TOOL", "lineatlas")

CUBE_POSITIONS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
CUBE_TRIANGLES = np.array(
    [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
     [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]], np.uint32)
# The corner (1, 1, 1) faces the eye, so three faces are visible.
CUBE_VIEW = lineatlas.View(eye=(4, 3, 5), target=(0.5, 0.5, 0.5))


def cube(**arguments) -> lineatlas.Mesh:
    return lineatlas.Mesh(CUBE_POSITIONS, CUBE_TRIANGLES, **arguments)


def dark_share(picture: np.ndarray) -> float:
    return float((picture[..., 0] < 128).mean())


def png_rows(path: pathlib.Path) -> bytes:
    """The header of a PNG file and its rows as they are before compression."""
    data = path.read_bytes()
    header, rows, at = b"", b"", 8
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        header += body if kind == b"IHDR" else b""
        rows += body if kind == b"IDAT" else b""
        at += length + 12
    return header + zlib.decompress(rows)


def inflated(pdf: bytes) -> bytes:
    """A PDF and what its compressed streams hold: newer versions of cairo write objects there."""
    text = pdf
    for part in re.findall(rb"stream\r?\n(.*?)\r?\nendstream", pdf, re.S):
        try:
            text += zlib.decompress(part)
        except zlib.error:
            pass
    return text


def run_tool(*words: object) -> None:
    subprocess.run([TOOL, *map(str, words)], check=True, capture_output=True)


class FolderTest(unittest.TestCase):
    """Has a folder of its own."""

    def setUp(self) -> None:
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
