"""The picture of the lines over the render, by nodes."""

NAMES = {"image": "lineatlas lines", "over": "lineatlas over"}


def output_of(tree):
    for node in tree.nodes:
        if node.type == "COMPOSITE":
            return node
    node = tree.nodes.new("CompositorNodeComposite")
    node.location = (600, 0)
    return node


def source_of(tree, output):
    """What the output shows so far; with nothing there, the render."""
    if output.inputs["Image"].is_linked:
        return output.inputs["Image"].links[0].from_socket
    for node in tree.nodes:
        if node.type == "R_LAYERS":
            return node.outputs["Image"]
    return tree.nodes.new("CompositorNodeRLayers").outputs["Image"]


def lay_over(scene, image, first, last):
    """Lays the image, of several frames a sequence, over what the scene's compositor shows."""
    scene.use_nodes = True
    tree = scene.node_tree
    lines, over = tree.nodes.get(NAMES["image"]), tree.nodes.get(NAMES["over"])
    if lines is None or over is None:
        output = output_of(tree)
        before = source_of(tree, output)
        lines, over = tree.nodes.new("CompositorNodeImage"), tree.nodes.new("CompositorNodeAlphaOver")
        lines.name = lines.label = NAMES["image"]
        over.name = over.label = NAMES["over"]
        lines.location = (output.location[0] - 400, output.location[1] - 200)
        over.location = (output.location[0] - 200, output.location[1])
        tree.links.new(before, over.inputs[1])
        tree.links.new(lines.outputs["Image"], over.inputs[2])
        tree.links.new(over.outputs["Image"], output.inputs["Image"])
    lines.image = image
    if image.source == "SEQUENCE":
        lines.frame_start, lines.frame_duration, lines.frame_offset = first, last - first + 1, first - 1
        lines.use_auto_refresh = True
    return lines
