"""The panel in the render properties."""

import bpy


class LINEATLAS_PT_lines(bpy.types.Panel):
    bl_label = "lineatlas"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        settings, layout = context.scene.lineatlas, self.layout
        row = layout.row(align=True)
        row.operator("lineatlas.draw", icon="RENDER_STILL")
        row.operator("lineatlas.draw", text="Draw Animation", icon="RENDER_ANIMATION").animation = True
        layout.use_property_split = True
        layout.use_property_decorate = False
        self.draw_outputs(layout.column(heading="Output"), settings)
        column = layout.column()
        column.prop(settings, "kinds")
        self.choice(layout, settings, "by_angle", "crease")
        layout.prop(settings, "style")
        layout.prop(settings, "style_file")
        self.choice(layout, settings, "by_width", "width")
        self.choice(layout, settings, "by_color", "color")
        layout.prop(settings, "hidden")

    def draw_outputs(self, column, settings):
        column.prop(settings, "picture")
        row = column.row()
        row.active = settings.picture
        row.prop(settings, "compose")
        column.prop(settings, "svg")
        column.prop(settings, "strokes")

    def choice(self, layout, settings, switch, value):
        row = layout.row(heading=settings.bl_rna.properties[switch].name)
        row.prop(settings, switch, text="")
        rest = row.row()
        rest.active = getattr(settings, switch)
        rest.prop(settings, value, text="")
