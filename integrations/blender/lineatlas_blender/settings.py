"""What a user may choose, kept in the scene."""

import math

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty, StringProperty

from .drawing import Lines

KINDS = [
    ("silhouette", "Silhouettes", "Where a surface turns away"),
    ("crease", "Creases", "Edges that are bent, and those with a Freestyle mark"),
    ("boundary", "Boundaries", "Where a surface ends"),
    ("material", "Materials", "Between parts and materials"),
    ("intersection", "Intersections", "Where parts pass through each other"),
    ("file", "Loose edges", "Edges of no face"),
    ("ridge", "Ridges", "Crests of scanned and sculpted surfaces"),
    ("valley", "Valleys", "Furrows of scanned and sculpted surfaces"),
]
# The items of a flag enum by its bits.
KIND_ITEMS = [(name, label, what, 1 << bit) for bit, (name, label, what) in enumerate(KINDS)]
STYLES = [("plain", "Plain", "Even black lines")] + [
    (name, name.capitalize(), "") for name in ("technical", "ink", "pencil", "charcoal", "blueprint", "haloed")]


class LineatlasSettings(bpy.types.PropertyGroup):
    kinds: EnumProperty(name="Lines", items=KIND_ITEMS, options={"ENUM_FLAG"}, default={name for name, _, _ in KINDS})
    by_angle: BoolProperty(name="Crease Angle", default=False,
                           description="Edges bent by more than this are creases; else by more than 28.8 degrees, except noise")
    crease: FloatProperty(name="Angle", subtype="ANGLE", default=0.5235988, min=0, max=3.1415926,
                          description="By how much an edge must be bent")
    style: EnumProperty(name="Style", items=STYLES, default="plain")
    style_file: StringProperty(name="Style File", subtype="FILE_PATH", description="A style of your own in place of the built-in one")
    by_width: BoolProperty(name="Width", default=False, description="A width of your own in place of the style's")
    width: FloatProperty(name="Pixels", default=2, min=0.1, soft_max=20, subtype="PIXEL")
    by_color: BoolProperty(name="Color", default=False, description="A color of your own in place of the style's")
    color: FloatVectorProperty(name="Color", subtype="COLOR_GAMMA", size=3, min=0, max=1, default=(0, 0, 0))
    hidden: BoolProperty(name="Hidden Lines", default=False, description="Draw what is hidden, too, as the style has it")
    picture: BoolProperty(name="Picture", default=True, description="A PNG beside the render, as an image for the compositor. Needs OpenGL")
    compose: BoolProperty(name="Over the Render", default=True, description="Lay the picture over the render, by compositor nodes")
    svg: BoolProperty(name="SVG", default=False, description="Paths beside the render, tagged with parts and materials")
    strokes: BoolProperty(name="Grease Pencil", default=False, description="Strokes that lie on the model, a layer for each kind of line")

    def named_style(self):
        if self.style_file:
            return bpy.path.abspath(self.style_file)
        return None if self.style == "plain" else self.style

    def lines(self):
        return Lines(kinds=sorted(self.kinds) if len(self.kinds) < len(KINDS) else None,
                     crease=math.degrees(self.crease) if self.by_angle else None,
                     style=self.named_style(),
                     width=self.width if self.by_width else None, color=tuple(self.color) if self.by_color else None,
                     hidden=self.hidden)
