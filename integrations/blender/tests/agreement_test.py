"""Lines lie where the outline of Cycles' picture is, within half a pixel."""

import bpy
import numpy as np
from lineatlas_blender import Drawer, Lines, collect
from scenes import SceneTest, distances, outline, strays

HALF_A_PIXEL = 0.5


class Agreement(SceneTest):
    def compare(self, least=150):
        drawer = Drawer(Lines())
        self.addCleanup(drawer.close)
        drawer.show(collect(self.scene, bpy.context.view_layer))
        found = drawer.intervals()
        self.assertTrue(found["visible"].all())
        alpha = self.rendered()[..., 3]
        self.assertEqual(drawer.frame.shot.size, alpha.shape[::-1])
        p, q = found["p"].astype(float), found["q"].astype(float)
        points = outline(alpha)
        self.assertGreater(len(points), least)
        self.assertLess(distances(points, p, q).max(), HALF_A_PIXEL)  # nothing of the outline is missing
        self.assertEqual(len(strays(alpha, p, q)), 0)  # nothing is drawn beside the object
        return found

    def test_perspective(self):
        self.wedge()
        self.camera((4, -5, 3))
        self.compare()

    def test_shift_and_another_sensor(self):
        self.wedge()
        self.camera((4, -5, 3), shift_x=0.17, shift_y=-0.09, sensor_fit="VERTICAL", lens=31)
        self.compare()

    def test_orthographic_with_shift(self):
        self.wedge()
        self.camera((4, -5, 3), type="ORTHO", ortho_scale=5, shift_x=-0.1, shift_y=0.06)
        self.compare()

    def test_upright_picture_with_tall_pixels_at_half_size(self):
        self.wedge()
        render = self.scene.render
        render.resolution_x, render.resolution_y, render.resolution_percentage = 400, 601, 50
        render.pixel_aspect_y = 1.5
        self.camera((4, -5, 3))
        self.compare()

    def test_cropped_to_the_border(self):
        self.wedge()
        render = self.scene.render
        render.use_border = render.use_crop_to_border = True
        render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = 0.31, 0.77, 0.2, 0.83
        self.camera((4, -5, 3))
        self.compare(least=50)

    def test_clipping(self):
        """What is nearer than the camera's clip start is neither rendered nor drawn."""
        self.wedge("far")
        near = self.wedge("near")
        near.location = (2.4, -3, 1.8)
        near.scale = (0.2, 0.2, 0.2)
        self.camera((4, -5, 3), clip_start=4.5, clip_end=100)
        found = self.compare()
        self.assertEqual(set(found["group"]), {0})

    def test_mirrored_instances_of_a_collection(self):
        one = bpy.data.collections.new("wedges")
        self.wedge(collection=one)
        for name, place, scale in (("left", (-2, 0, 0), (-1, 1, 1)), ("right", (1.6, 0.3, 0.2), (0.8, 1.1, -0.9))):
            instancer = bpy.data.objects.new(name, None)
            instancer.instance_type, instancer.instance_collection = "COLLECTION", one
            instancer.location, instancer.scale = place, scale
            instancer.rotation_euler = (0.2, 0.1, 0.4)
            self.scene.collection.objects.link(instancer)
        self.camera((3, -8, 4))
        self.compare()
        arrays = collect(self.scene, bpy.context.view_layer).arrays
        self.assertEqual([part for part, _, _ in arrays.groups], ["left/wedge", "right/wedge"])
        for group in (0, 1):  # outward faces stay outward: the volume that they enclose is above zero
            corners = arrays.positions[arrays.triangles[arrays.triangle_group == group]]
            volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
            self.assertGreater(volume, 1)

    def test_modifiers_at_their_levels_for_rendering(self):
        item = self.wedge()
        levels = item.modifiers.new("smooth", "SUBSURF")
        levels.levels, levels.render_levels = 0, 3
        item.modifiers.new("mirror", "MIRROR").use_axis = (True, False, False)
        hidden = self.wedge("hidden in renders")
        hidden.location, hidden.hide_render = (0, 0, 2), True
        self.camera((4, -5, 3))
        self.compare()

    def test_far_from_zero(self):
        item = self.wedge()
        item.location = (52000, -31000, 700)
        self.camera((52004, -31005, 703), target=(52000, -31000, 700))
        drawer = Drawer(Lines())
        self.addCleanup(drawer.close)
        drawer.show(collect(self.scene, bpy.context.view_layer))
        item.location = (0, 0, 0)
        self.scene.camera.location = (4, -5, 3)
        near = Drawer(Lines())
        self.addCleanup(near.close)
        near.show(collect(self.scene, bpy.context.view_layer))
        far_away, at_zero = drawer.intervals(), near.intervals()
        self.assertEqual(len(far_away), len(at_zero))
        # Blender's own matrices are 32-bit floats: 0.004 units there, at 7 units' distance and 445 pixels' focal length.
        self.assertLess(np.abs(far_away["p"] - at_zero["p"]).max(), 0.5)

    def test_curves_and_text(self):
        curve = bpy.data.curves.new("text", "FONT")
        curve.body, curve.extrude, curve.align_x = "Ob", 0.2, "CENTER"
        self.scene.collection.objects.link(bpy.data.objects.new("text", curve))
        self.camera((0.6, -1, 3))
        self.compare()
