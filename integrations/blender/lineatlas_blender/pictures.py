"""Pictures and SVG beside the render's own files, and the picture as an image of Blender's."""

import contextlib
import os
import pathlib

import bpy
import numpy as np

from .errors import DrawingError

IMAGE = "lineatlas lines"


def path_of(scene, number, ending):
    """Beside the render: /tmp/0001.png has its lines in /tmp/0001_lines.png."""
    render = pathlib.Path(bpy.path.abspath(scene.render.frame_path(frame=number)))
    return render.with_name(render.stem + "_lines" + ending)


def written(path, write):
    """A file that appears whole or not at all."""
    unfinished = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        write(unfinished)
        os.replace(unfinished, path)
    except (OSError, RuntimeError) as error:
        with contextlib.suppress(OSError):
            unfinished.unlink()
        raise DrawingError(f"{path} cannot be written: {error}") from None
    return path


def save_text(path, text):
    return written(path, lambda file: file.write_text(text, encoding="utf-8"))


def save_picture(path, picture):
    """A picture of Drawer.picture() as PNG."""
    height, width = picture.shape[:2]
    image = bpy.data.images.new("lineatlas unsaved", width, height, alpha=True)
    try:
        image.alpha_mode, image.file_format = "STRAIGHT", "PNG"
        image.pixels.foreach_set((picture[::-1].astype(np.float32) / 255).ravel())

        def write(file):
            image.filepath_raw = str(file)
            image.save()

        return written(path, write)
    finally:
        bpy.data.images.remove(image)


def image_of(path, frames):
    """What was saved, as an image for the compositor and the image editor: of several frames a sequence."""
    image = bpy.data.images.get(IMAGE) or bpy.data.images.load(str(path))
    image.name, image.filepath = IMAGE, str(path)
    image.source = "FILE" if frames == 1 else "SEQUENCE"
    image.reload()
    return image
