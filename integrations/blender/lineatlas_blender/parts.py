"""What is drawn has names: collections and objects become parts, materials stay materials."""

import numpy as np


def paths_of(collection, above=""):
    """Of every object the collections that lead to it: "house/roof"."""
    found = {}
    for child in collection.children:
        path = f"{above}/{child.name}" if above else child.name
        for name, place in paths_of(child, path).items():
            found.setdefault(name, place)
    for item in collection.objects:
        found.setdefault(item.name, above)
    return found


def srgb(color):
    """Of linear values what is on the screen."""
    linear = np.clip(np.array(color[:3], float), 0, 1)
    return tuple(np.where(linear <= 0.0031308, linear * 12.92, 1.055 * linear ** (1 / 2.4) - 0.055))


def color_of(material):
    """That of its principled shader, unless a texture gives it; else the viewport's."""
    if material.use_nodes and material.node_tree:
        for node in material.node_tree.nodes:
            if node.type == "BSDF_PRINCIPLED" and not node.inputs["Base Color"].is_linked:
                return srgb(node.inputs["Base Color"].default_value)
    return srgb(material.diffuse_color)


def materials_of(item):
    """Names and colours of an object's slots; an object without slots has one without a name."""
    slots = [slot.material for slot in item.material_slots] or [None]
    return [(slot.name, color_of(slot)) if slot else ("", None) for slot in slots]


class Names:
    """Names of parts, each once."""

    def __init__(self, scene):
        self._paths = paths_of(scene.collection)
        self._count = {}

    def part(self, instance):
        """"collections/object", of an instance "collections/instancer/object"."""
        names = [instance.object.original.name]
        top = names[0]
        if instance.is_instance and instance.parent:
            top = instance.parent.original.name
            names.insert(0, top)
        above = self._paths.get(top, "")
        path = "/".join(([above] if above else []) + names)
        self._count[path] = self._count.get(path, 0) + 1
        return path if self._count[path] == 1 else f"{path} {self._count[path]}"
