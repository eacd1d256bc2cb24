"""Lines of the scene by lineatlas: over the render, as SVG, as Grease Pencil.

From a script: bpy.ops.lineatlas.draw(animation=True) with the settings of scene.lineatlas, or

    from lineatlas_blender import Job, Lines, run
    run(Job(bpy.context.scene, bpy.context.view_layer, Lines(style="pencil"), frames=[1, 2, 3], svg=True))
"""

import bpy

bl_info = {
    "name": "lineatlas: line drawings",
    "author": "The lineatlas developers",
    "version": (0, 1, 0),
    "blender": (3, 3, 0),
    "location": "Render properties > lineatlas",
    "description": "What is visible of the scene's lines: over the render, as SVG, as Grease Pencil strokes",
    "category": "Render",
}

if bpy.app.version < bl_info["blender"]:
    raise ImportError(f"lineatlas needs Blender {'.'.join(map(str, bl_info['blender'][:2]))} or newer, "
                      f"but this is {bpy.app.version_string}")

from .collector import collect  # noqa: E402
from .drawing import Drawer, Lines  # noqa: E402
from .errors import DrawingError  # noqa: E402
from .job import Job, run  # noqa: E402
from .operators import LINEATLAS_OT_draw  # noqa: E402
from .panel import LINEATLAS_PT_lines  # noqa: E402
from .preferences import LineatlasPreferences  # noqa: E402
from .settings import LineatlasSettings  # noqa: E402

__all__ = ["Drawer", "DrawingError", "Job", "Lines", "collect", "run"]

CLASSES = (LineatlasPreferences, LineatlasSettings, LINEATLAS_OT_draw, LINEATLAS_PT_lines)


def register():
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.Scene.lineatlas = bpy.props.PointerProperty(type=LineatlasSettings)


def unregister():
    del bpy.types.Scene.lineatlas
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
