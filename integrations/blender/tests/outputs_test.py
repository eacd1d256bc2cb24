"""What the operator and scripts leave: pictures, SVG, Grease Pencil, compositor nodes, a frame range."""

import re
import types
import unittest.mock

import bpy
import numpy as np
from bpy_extras.object_utils import world_to_camera_view
from lineatlas_blender import Drawer, Job, Lines, collect, run
from lineatlas_blender.operators import LINEATLAS_OT_draw
from mathutils import Vector
from scenes import SceneTest, distances, pixels_of


class Outputs(SceneTest):
    def setUp(self):
        super().setUp()
        self.item = self.wedge()
        self.shot = self.camera((4, -5, 3))

    def job(self, **wanted):
        return Job(self.scene, bpy.context.view_layer, **wanted)

    def intervals(self):
        drawer = Drawer(Lines())
        self.addCleanup(drawer.close)
        drawer.show(collect(self.scene, bpy.context.view_layer))
        found = drawer.intervals()
        return found["p"].astype(float), found["q"].astype(float)

    def test_a_picture_is_dark_where_lines_are_and_clear_elsewhere(self):
        self.assertEqual(bpy.ops.lineatlas.draw(), {"FINISHED"})
        picture = pixels_of(self.folder / "render_0001_lines.png")
        self.assertEqual(picture.shape, (240, 320, 4))
        rows, columns = np.nonzero(picture[..., 3] > 0.5)
        self.assertGreater(len(rows), 500)
        centres = np.stack([columns + 0.5, rows + 0.5], axis=1)
        p, q = self.intervals()
        self.assertLess(distances(centres, p, q).max(), 1.5)
        self.assertLess(picture[rows, columns, :3].max(), 0.2)
        middles = np.floor((p + q) / 2).astype(int)
        self.assertGreater(picture[middles[:, 1], middles[:, 0], 3].min(), 0.3)
        self.assertEqual(picture[5, 5, 3], 0)
        self.assertEqual(tuple(bpy.data.images["lineatlas lines"].size), (320, 240))

    def test_lines_lie_over_the_render(self):
        """In what Cycles and the compositor write, a line is dark and what is beside it is as bright as without it."""
        light = bpy.data.lights.new("sun", "SUN")
        light.energy = 3
        sun = bpy.data.objects.new("sun", light)
        sun.rotation_euler = (0.6, 0.3, 0)
        self.scene.collection.objects.link(sun)
        self.scene.lineatlas.by_width, self.scene.lineatlas.width = True, 3
        before = self.rendered()
        for _ in range(2):  # drawn again, the nodes are the same
            bpy.ops.lineatlas.draw()
        self.assertEqual(sum(node.type == "ALPHAOVER" for node in self.scene.node_tree.nodes), 1)
        after = self.rendered()
        p, q = self.intervals()
        middles = np.floor((p + q) / 2).astype(int)
        self.assertLess(after[middles[:, 1], middles[:, 0], :3].max(), 0.1)
        rows, columns = np.nonzero(before[..., 3] > 0.99)
        away = distances(np.stack([columns + 0.5, rows + 0.5], axis=1), p, q) > 4
        self.assertGreater(away.sum(), 1000)
        difference = np.abs(after - before)[rows[away], columns[away]]
        self.assertLess(difference.max(), 0.02)
        self.assertGreater(before[rows[away], columns[away], :3].mean(), 0.1)

    def test_svg_has_parts_and_materials(self):
        house = bpy.data.collections.new("house")
        roof = bpy.data.collections.new("roof")
        self.scene.collection.children.link(house)
        house.children.link(roof)
        second = self.wedge("tile", collection=roof)
        second.location = (-0.5, 0.6, 1)
        second.data.materials.append(bpy.data.materials.new("clay & straw"))
        settings = self.scene.lineatlas
        settings.picture, settings.svg = False, True
        bpy.ops.lineatlas.draw()
        text = (self.folder / "render_0001_lines.svg").read_text()
        self.assertIn("object house/roof/tile; material clay &amp; straw", text)
        self.assertIn("object wedge", text)
        self.assertIn('class="intersection visible"', text)
        self.assertNotIn("<rect", text)

    def test_three_frames(self):
        for frame, place in ((1, (4, -5, 3)), (3, (5, -4, 2))):
            self.shot.location = place
            self.shot.keyframe_insert("location", frame=frame)
        self.scene.frame_start, self.scene.frame_end = 1, 3
        self.scene.frame_set(2)
        settings = self.scene.lineatlas
        settings.svg = settings.strokes = True
        self.assertEqual(bpy.ops.lineatlas.draw(animation=True), {"FINISHED"})
        self.assertEqual(self.scene.frame_current, 2)
        pictures = [pixels_of(self.folder / f"render_000{frame}_lines.png") for frame in (1, 2, 3)]
        self.assertFalse(np.array_equal(pictures[0], pictures[1]) or np.array_equal(pictures[1], pictures[2]))
        texts = {(self.folder / f"render_000{frame}_lines.svg").read_text() for frame in (1, 2, 3)}
        self.assertEqual(len(texts), 3)
        image = bpy.data.images["lineatlas lines"]
        self.assertEqual(image.source, "SEQUENCE")
        node = self.scene.node_tree.nodes["lineatlas lines"]
        self.assertEqual((node.frame_start, node.frame_duration, node.frame_offset), (1, 3, 0))
        # The compositor takes each frame's own picture.
        for item in self.scene.objects:  # strokes are rendered, too
            item.hide_render = item != self.shot
        for frame, picture in zip((1, 2, 3), pictures):
            self.scene.frame_set(frame)
            alpha = self.rendered()[..., 3]
            self.assertLess(np.abs(alpha - picture[..., 3]).max(), 0.01, frame)

    def test_lines_are_found_once_while_only_the_camera_moves(self):
        drawer = Drawer(Lines())
        self.addCleanup(drawer.close)
        drawer.show(collect(self.scene, bpy.context.view_layer))
        first = drawer.arrays
        self.shot.location = (4, -5, 2)
        self.assertTrue(first.same_shape(collect(self.scene, bpy.context.view_layer).arrays))
        self.item.location = (0.1, 0, 0)
        self.assertFalse(first.same_shape(collect(self.scene, bpy.context.view_layer).arrays))

    def test_it_stops_when_told_so(self):
        said = []
        job = self.job(frames=[1, 2, 3], picture=False, svg=True)
        run(job, progress=lambda done, all: said.append((done, all)) or done < 2)
        self.assertEqual(said, [(1, 3), (2, 3)])
        self.assertEqual([path.name for path in job.files], ["render_0001_lines.svg", "render_0002_lines.svg"])
        self.assertEqual(self.scene.frame_current, 1)

    def test_the_operator_goes_frame_by_frame_and_esc_stops_it(self):
        """Without a window there are no events: they are handed to it here."""
        said = []
        operator = types.SimpleNamespace(job=self.job(frames=[1, 2, 3], picture=False, svg=True), timer=None,
                                         report=lambda kind, text: said.append(text))
        for name in ("step", "end", "say_progress", "say_what_was_done"):
            setattr(operator, name, types.MethodType(getattr(LINEATLAS_OT_draw, name), operator))
        operator.steps = operator.job.steps()
        context = unittest.mock.Mock()

        def event(kind):
            return LINEATLAS_OT_draw.modal(operator, context, types.SimpleNamespace(type=kind))

        self.assertEqual(event("MOUSEMOVE"), {"PASS_THROUGH"})
        self.assertEqual(event("TIMER"), {"RUNNING_MODAL"})
        context.window_manager.progress_update.assert_called_with(1)
        context.workspace.status_text_set.assert_called_with("Drawing lines: 1 of 3 frames (Esc stops)")
        self.assertEqual(event("ESC"), {"CANCELLED"})
        context.workspace.status_text_set.assert_called_with(None)
        self.assertEqual(said, ["Stopped; what was drawn so far stays"])
        self.assertEqual([path.name for path in operator.job.files], ["render_0001_lines.svg"])

    def test_strokes_lie_on_the_model_and_on_its_lines(self):
        self.scene.lineatlas.picture, self.scene.lineatlas.strokes = False, True
        for _ in range(2):  # drawn again, they take the place of those before
            bpy.ops.lineatlas.draw()
        items = [item for item in self.scene.objects if item.type == "GPENCIL"]
        self.assertEqual(len(items), 1)
        p, q = self.intervals()
        ends, count = [], 0
        for layer in items[0].data.layers:
            self.assertEqual([frame.frame_number for frame in layer.frames], [1])
            for stroke in layer.frames[0].strokes:
                count += 1
                for point in stroke.points:
                    seen = world_to_camera_view(self.scene, self.shot, Vector(point.co))
                    ends.append((seen.x * 320, (1 - seen.y) * 240))
        self.assertIn("crease", items[0].data.layers)
        self.assertGreaterEqual(count, 5)
        self.assertLess(distances(np.array(ends), p, q).max(), 0.05)

    def test_a_freestyle_mark_is_a_crease_however_flat(self):
        side = np.linspace(-1, 1, 5)
        grid = [(x, y, 0) for y in side for x in side]
        faces = [(i, i + 1, i + 6, i + 5) for row in range(4) for i in range(row * 5, row * 5 + 4)]
        self.item.hide_render = True
        sheet = self.mesh("sheet", grid, faces)

        def creases():
            drawer = Drawer(Lines(kinds=["crease"]))
            self.addCleanup(drawer.close)
            drawer.show(collect(self.scene, bpy.context.view_layer))
            found = drawer.intervals()
            return {tuple(sorted(edge)) for edge in found["edge"].tolist()}

        self.assertEqual(creases(), set())
        for edge in sheet.data.edges:
            edge.use_freestyle_mark = set(edge.vertices) in ({11, 12}, {12, 13})
        self.assertEqual(creases(), {(11, 12), (12, 13)})

    def test_settings(self):
        settings = self.scene.lineatlas
        settings.kinds, settings.style = {"crease"}, "pencil"
        settings.by_color, settings.color = True, (1, 0, 0)
        settings.picture, settings.svg, settings.hidden = False, True, True
        bpy.ops.lineatlas.draw()
        text = (self.folder / "render_0001_lines.svg").read_text()
        self.assertEqual(set(re.findall(r'class="(\w+)', text)), {"crease"})  # outlines are creases here
        self.assertIn('stroke="#ff0000"', text)
        self.assertIn("crease-hidden", text)
