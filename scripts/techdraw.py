"""Draws a model of exact surfaces by FreeCAD's TechDraw as lineatlas would write it:
techdraw.py MODEL OUTPUT.svg [LIKE.json DRAWING.json]
OUTPUT.svg is FreeCAD's own, seen isometrically; DRAWING.json has its lines with the orthographic camera of LIKE.json, a drawing
of lineatlas. See compare_techdraw.sh."""
import json
import math
import os
import re
import sys
import time

sys.path += [os.environ.get("FREECAD_LIB", "/usr/lib/freecad-python3/lib"), "/usr/lib/freecad/Mod"]
import FreeCAD  # noqa: E402
import Part  # noqa: E402
import TechDraw  # noqa: E402


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def axes_of(toward_eye):
    """Those of the picture that Open CASCADE makes of a direction alone (gp_Ax2)."""
    a, b, c = toward_eye
    if abs(b) <= abs(a) and abs(b) <= abs(c):
        x = [-c, 0, a] if abs(a) > abs(c) else [c, 0, -a]
    elif abs(a) <= abs(b) and abs(a) <= abs(c):
        x = [0, -c, b] if abs(b) > abs(c) else [0, c, -b]
    else:
        x = [-b, a, 0] if abs(a) > abs(b) else [b, -a, 0]
    x = unit(x)
    return x, cross(toward_eye, x)


def camera_of(like):
    number = r"[-+.\deE,]+"
    pattern = rf"--eye ({number}) --target ({number}) --up ({number}) --fov ({number})"
    eye, target, up, fov = re.search(pattern, like["description"]).groups()
    eye, target, up = ([float(v) for v in text.split(",")] for text in (eye, target, up))
    arm = [e - t for e, t in zip(eye, target)]
    shown = 2 * math.sqrt(dot(arm, arm)) * math.tan(math.radians(float(fov)) / 2)
    back = unit(arm)
    right = unit(cross(up, back))
    return target, back, right, cross(back, right), like["size"][1] / shown


def lines_of(shape, like, deviation):
    """Sharp edges and outlines that can be seen, in pixels; smooth edges and seams are none."""
    target, back, right, up, scale = camera_of(like)
    width, height = like["size"]
    x_axis, y_axis = axes_of(back)
    groups = TechDraw.projectEx(shape, FreeCAD.Vector(*back))
    paths = []
    for group in (groups[0], groups[3]):  # visible sharp edges (V) and visible outlines (VO)
        for edge in group.Edges:
            points = []
            for at in edge.discretize(Deflection=deviation):
                way = [at.x * x + at.y * y - t for x, y, t in zip(x_axis, y_axis, target)]
                points.append([width / 2 + scale * dot(way, right), height / 2 - scale * dot(way, up)])
            paths.append(points)
    return paths


def main(model, output, like_name=None, drawing_name=None):
    shape = Part.Shape()
    shape.read(model)
    if like_name is None:
        with open(output, "w") as file:
            file.write(TechDraw.projectToSVG(shape, FreeCAD.Vector(1, -1, 1)))
        return
    with open(like_name) as file:
        like = json.load(file)
    begin = time.monotonic()
    paths = lines_of(shape, like, 0.002 / camera_of(like)[4] * 10)
    print(f"projected in {time.monotonic() - begin:.1f} s")
    drawing = {"format": like["format"], "version": like["version"], "units": "pixels", "size": like["size"],
               "description": like["description"],
               "paths": [{"visible": True, "points": points} for points in paths]}
    with open(drawing_name, "w") as file:
        json.dump(drawing, file)


main(*sys.argv[1:])
