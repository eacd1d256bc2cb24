"""The add-on as packages install it draws Blender's own first scene, a cube of which three sides are seen:
blender -b --factory-startup --python-exit-code 1 --python package.py -- FOLDER"""

import pathlib
import sys

import addon_utils
import bpy
import numpy as np

folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
addon_utils.enable("lineatlas_blender", default_set=True, handle_error=lambda error: sys.exit(str(error)))

from lineatlas_blender import Drawer, Lines, collect  # noqa: E402

scene = bpy.context.scene
scene.render.filepath = str(folder / "blender_")
scene.render.resolution_percentage = 25
settings = scene.lineatlas
settings.svg, settings.strokes = True, True
bpy.ops.lineatlas.draw()

drawer = Drawer(Lines())
drawer.show(collect(scene, bpy.context.view_layer))
found = drawer.intervals(hidden=True)
drawer.close()
ends = np.sort(found["edge"], axis=1)
seen = {tuple(edge) for edge in ends[found["visible"]]}
hidden = {tuple(edge) for edge in ends[~found["visible"]]}
assert (len(seen), len(hidden), len(seen & hidden)) == (9, 3, 0), (seen, hidden)

picture = bpy.data.images.load(str(folder / "blender_0001_lines.png"))
alpha = np.array(picture.pixels[:]).reshape(picture.size[1], picture.size[0], 4)[::-1, :, 3]
for edge in found[found["visible"]]:
    x, y = ((edge["p"] + edge["q"]) / 2).astype(int)
    assert alpha[y - 1:y + 2, x - 1:x + 2].max() > 0.9, f"no line at {x}, {y}"
assert 0 < (alpha > 0).mean() < 0.05, "a picture of lines has little but paper"
assert (folder / "blender_0001_lines.svg").read_text().count("<path ") >= 3
strokes = bpy.data.objects["lineatlas lines"].data
assert sum(len(layer.frames[0].strokes) for layer in strokes.layers) >= 3, "no Grease Pencil strokes"
