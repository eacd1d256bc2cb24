"""Lines as Grease Pencil strokes that lie on the model: a layer for each kind, a frame for each frame."""

import bpy

from .errors import DrawingError

NAME = "lineatlas lines"


def check():
    if bpy.app.version >= (4, 3):  # where Grease Pencil was made anew
        raise DrawingError("Grease Pencil strokes need Blender 3.3 to 4.2: save SVG, and import it as Grease Pencil")


def material_of(color):
    material = bpy.data.materials.get(NAME) or bpy.data.materials.new(NAME)
    if not material.grease_pencil:
        bpy.data.materials.create_gpencil_data(material)
    material.grease_pencil.color = (*(color or (0, 0, 0)), 1)
    return material


def object_in(scene, color):
    """The object of these lines in the scene, of an earlier drawing if there was one."""
    for item in scene.collection.all_objects:
        if item.type == "GPENCIL" and item.data.name.startswith(NAME):
            item.data.materials[0] = material_of(color)
            return item
    data = bpy.data.grease_pencils.new(NAME)
    data.stroke_thickness_space = "SCREENSPACE"
    data.materials.append(material_of(color))
    item = bpy.data.objects.new(NAME, data)
    item.show_in_front = True  # lines lie in the surface
    scene.collection.objects.link(item)
    return item


def fresh_frame(data, name, number):
    layer = data.layers.get(name) or data.layers.new(name)
    layer.use_lights = False
    for frame in layer.frames:
        if frame.frame_number == number:
            frame.clear()
            return frame
    return layer.frames.new(number)


def add(frame, path, width):
    stroke = frame.strokes.new()
    stroke.display_mode = "3DSPACE"
    stroke.line_width = max(1, round(width))
    stroke.use_cyclic = path["closed"]
    points = path["world"][:-1] if path["closed"] else path["world"]  # which closes by itself
    stroke.points.add(len(points))
    stroke.points.foreach_set("co", points.ravel())
    stroke.points.foreach_set("pressure", [1.0] * len(points))
    stroke.points.foreach_set("strength", [1.0] * len(points))
    stroke.points.update()


def draw(scene, number, paths, color, width):
    """Adds the strokes of a frame in place of those that it had."""
    item = object_in(scene, color)
    frames = {layer.info: fresh_frame(item.data, layer.info, number) for layer in item.data.layers}
    for path in paths:
        name = path["kind"] if path["visible"] else f"{path['kind']} hidden"
        if name not in frames:
            frames[name] = fresh_frame(item.data, name, number)
            item.data.layers[name].opacity = 1 if path["visible"] else 0.3
        add(frames[name], path, width)
    return item
