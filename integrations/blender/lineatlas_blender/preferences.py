"""Where the Python package is, if Blender's Python does not find it."""

import bpy
from bpy.props import StringProperty

from . import library
from .errors import DrawingError


class LineatlasPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    folder: StringProperty(name="Python Package", subtype="DIR_PATH",
                           description="The folder that holds the package lineatlas; empty: where Blender's Python looks")

    def draw(self, context):
        self.layout.prop(self, "folder")
        try:
            self.layout.label(text=f"lineatlas {library.load().__version__} is found", icon="CHECKMARK")
        except DrawingError as error:
            self.layout.label(text=str(error), icon="ERROR")
