"""Draws a model by Blender's Line Art or Freestyle, or by the add-on, as lineatlas would write it:
blender --background --python line_art.py -- line_art|freestyle|addon MODEL.obj LIKE.json DRAWING.json
Camera and picture size are those of LIKE.json, a drawing of lineatlas. See compare_line_art.sh."""
import json
import math
import pathlib
import re
import sys
import time

import bpy
from mathutils import Matrix, Vector

crease = math.radians(30)  # edges bent by more are creases, as in lineatlas


def camera_of(description):
    number = r"[-+.\deE,]+"
    pattern = rf"--eye ({number}) --target ({number}) --up ({number}) --fov ({number})"
    eye, target, up, fov = re.search(pattern, description).groups()
    eye, target, up = (Vector(map(float, v.split(","))) for v in (eye, target, up))
    back = (eye - target).normalized()
    right = up.cross(back).normalized()
    return eye, right, back.cross(right), back, math.radians(float(fov))


def read_obj(name):
    """Positions without repeats, and triangles, of a file that `lineatlas scene` wrote."""
    index_of, of_file, faces = {}, [], []
    with open(name) as file:
        for line in file:
            word, *values = line.split()
            if word == "v":
                of_file.append(index_of.setdefault(tuple(map(float, values)), len(index_of)))
            elif word == "f":
                faces.append([of_file[int(value) - 1] for value in values])
    return list(index_of), faces


def set_up(model, like):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    positions, faces = read_obj(model)
    mesh = bpy.data.meshes.new("model")
    mesh.from_pydata(positions, [], faces)
    mesh.validate()
    bpy.context.scene.collection.objects.link(bpy.data.objects.new("model", mesh))
    eye, right, up, back, fov = camera_of(like["description"])
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.angle = "VERTICAL", fov
    depths = [(eye - Vector(position)).dot(back) for position in positions]
    data.clip_end = max(depths) * 1.01
    data.clip_start = max(min(depths) * 0.999, data.clip_end * 1e-3)
    camera = bpy.data.objects.new("camera", data)
    camera.matrix_world = Matrix.Translation(eye) @ Matrix((right, up, back)).transposed().to_4x4()
    scene = bpy.context.scene
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = like["size"]
    return scene


def line_art(scene, like):
    eye, right, up, back, fov = camera_of(like["description"])
    width, height = like["size"]
    focal = height / 2 / math.tan(fov / 2)
    pencil = bpy.data.grease_pencils.new("lines")
    layer = pencil.layers.new("lines")
    layer.frames.new(scene.frame_current)
    pencil.materials.append(bpy.data.materials.new("line"))
    bpy.data.materials.create_gpencil_data(pencil.materials[0])
    drawn = bpy.data.objects.new("lines", pencil)
    scene.collection.objects.link(drawn)
    modifier = drawn.grease_pencil_modifiers.new("lines", "GP_LINEART")
    modifier.source_type = "SCENE"
    modifier.target_layer, modifier.target_material = "lines", pencil.materials[0]
    modifier.use_contour = modifier.use_crease = True
    modifier.use_material = modifier.use_edge_mark = modifier.use_intersection = modifier.use_loose = False
    modifier.crease_threshold = math.pi - crease
    modifier.overscan = 0.1
    strokes = drawn.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.layers[0].frames[0].strokes
    paths = []
    for stroke in strokes:
        points = []
        for point in stroke.points:
            way = drawn.matrix_world @ point.co - eye
            depth = -way.dot(back)
            points.append([width / 2 + focal * way.dot(right) / depth, height / 2 - focal * way.dot(up) / depth])
        paths.append(points)
    return paths


collector = """
import bpy
from freestyle.types import Operators, StrokeShader, UnaryPredicate1D
from freestyle.predicates import NotUP1D, QuantitativeInvisibilityUP1D, TrueUP1D
from freestyle.chainingiterators import ChainSilhouetteIterator

class Collect(StrokeShader):
    def shade(self, stroke):
        bpy.app.driver_namespace["paths"].append([tuple(vertex.point) for vertex in stroke])

visible = QuantitativeInvisibilityUP1D(0)
Operators.select(visible)
Operators.bidirectional_chain(ChainSilhouetteIterator(), NotUP1D(visible))
Operators.create(TrueUP1D(), [Collect()])
"""


def freestyle(scene, like):
    bpy.app.driver_namespace["paths"] = []
    scene.render.engine = "CYCLES"  # Cycles needs no display
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False
    scene.render.use_freestyle = True
    settings = bpy.context.view_layer.freestyle_settings
    settings.mode = "SCRIPT"
    settings.crease_angle = math.pi - crease
    settings.use_smoothness = False
    text = bpy.data.texts.new("collector")
    text.write(collector)
    module = settings.modules.new()
    module.script = text
    bpy.ops.render.render()
    height = like["size"][1]
    return [[[x, height - y] for x, y in points] for points in bpy.app.driver_namespace["paths"]]


def addon(scene, like):
    sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "integrations/blender"))
    from lineatlas_blender import Drawer, Lines, collect

    drawer = Drawer(Lines(kinds=["crease", "boundary", "silhouette"]))
    drawer.show(collect(scene, bpy.context.view_layer))
    return [path["points"] for path in drawer.paths()[0] if path["visible"]]


def main(program, model, like_name, output):
    begin = time.monotonic()
    with open(like_name) as file:
        like = json.load(file)
    scene = set_up(model, like)
    paths = {"line_art": line_art, "freestyle": freestyle, "addon": addon}[program](scene, like)
    if not paths:
        sys.exit("nothing was drawn")
    drawing = {"format": like["format"], "version": like["version"], "units": "pixels", "size": like["size"],
               "description": like["description"],
               "paths": [{"visible": True, "points": points} for points in paths]}
    with open(output, "w") as file:
        json.dump(drawing, file)
    print(f"seconds {time.monotonic() - begin:.1f}")


main(*sys.argv[sys.argv.index("--") + 1:])
