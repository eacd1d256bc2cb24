"""A render engine that shows what a render sees, and draws nothing of its own but lines.

Only to a render engine does Blender show the scene as a render has it: modifiers at their levels for rendering,
what is hidden in renders left out.
"""

from contextlib import contextmanager

import bpy

from .camera import check, shot_of
from .errors import DrawingError
from .scene_reader import read

ENGINE = "LINEATLAS_COLLECTOR"


class Frame:
    """A scene in one frame."""

    def __init__(self, number, arrays, shot):
        self.number, self.arrays, self.shot = number, arrays, shot


class Collector(bpy.types.RenderEngine):
    bl_idname = ENGINE
    bl_label = "lineatlas (reads the scene)"
    bl_use_preview = False

    wanted = []  # where the frame goes: the render runs within a call of collect()

    def render(self, depsgraph):
        scene = depsgraph.scene_eval
        try:
            arrays, shot = read(depsgraph.scene, depsgraph), shot_of(scene, depsgraph)
            Collector.wanted.append(Frame(scene.frame_current, arrays, shot))
        except Exception as error:  # else Blender prints it and says that all went well
            Collector.wanted.append(error)


@contextmanager
def settings_for_reading(render):
    """The engine, and nothing that would run after it."""
    own = {"engine": ENGINE, "use_compositing": False, "use_sequencer": False, "use_freestyle": False,
           "use_multiview": False}
    before = {name: getattr(render, name) for name in own}
    try:
        for name, value in own.items():
            setattr(render, name, value)
        yield
    finally:
        for name, value in before.items():
            setattr(render, name, value)


def collect(scene, view_layer):
    """The scene as a render of the present frame has it."""
    check(scene)
    Collector.wanted.clear()
    bpy.utils.register_class(Collector)  # for now only: it is none of the engines to choose from
    try:
        with settings_for_reading(scene.render):
            bpy.ops.render.render(scene=scene.name, layer=view_layer.name)
    finally:
        bpy.utils.unregister_class(Collector)
    if not Collector.wanted:
        raise DrawingError("Blender did not show the scene to lineatlas: is another render running?")
    found = Collector.wanted.pop()
    if isinstance(found, Exception):
        raise found
    return found
