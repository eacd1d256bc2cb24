"""What stands in the way is said in one line, in Blender's way."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import types
import unittest.mock

import bpy
import lineatlas_blender
from lineatlas_blender import DrawingError, Job, collect, library
from scenes import SceneTest


class Refusals(SceneTest):
    def refused(self, pattern):
        """The operator's report of an error, of one line."""
        with self.assertRaisesRegex(RuntimeError, pattern) as caught:
            bpy.ops.lineatlas.draw()
        self.assertEqual(len(str(caught.exception).strip().splitlines()), 1)

    def test_no_camera(self):
        self.wedge()
        self.refused('the scene "Scene" has no camera')

    def test_a_light_for_a_camera(self):
        self.wedge()
        light = bpy.data.objects.new("lamp", bpy.data.lights.new("lamp", "POINT"))
        self.scene.collection.objects.link(light)
        self.scene.camera = light
        self.refused('"lamp" is no camera but a light')

    def test_a_panorama(self):
        self.wedge()
        self.camera((4, -5, 3), type="PANO")
        self.refused("is panoramic")

    def test_an_empty_scene(self):
        self.camera((4, -5, 3))
        self.refused("there is nothing to draw")

    def test_a_mesh_without_faces(self):
        self.camera((4, -5, 3))
        self.mesh("points", [(0, 0, 0), (1, 0, 0)], [])
        self.refused('the mesh of "points" has no faces: nothing of it is drawn')

    def test_loose_edges_are_drawn_and_said_to_be_all(self):
        self.camera((4, -5, 3))
        self.mesh("wire", [(0, 0, 0), (1, 0, 0), (1, 1, 0)], [], edges=[(0, 1), (1, 2)])
        job = lineatlas_blender.run(Job(self.scene, bpy.context.view_layer, picture=False, svg=True))
        self.assertEqual(job.notes, ['the mesh of "wire" has no faces: only its 2 loose edges are drawn'])
        self.assertIn('id="file"', job.files[0].read_text())

    def test_nothing_in_view(self):
        item = self.wedge()
        item.location = (0, 0, 100)
        self.camera((4, -5, 3))
        job = lineatlas_blender.run(Job(self.scene, bpy.context.view_layer, picture=False, svg=True))
        self.assertEqual(len(job.notes), 1)
        self.assertIn("no line is drawn", job.notes[0])

    def test_nothing_wanted(self):
        self.wedge()
        self.camera((4, -5, 3))
        self.scene.lineatlas.kinds = set()
        self.refused("no line is wanted")
        self.scene.lineatlas.picture = False
        self.refused("nothing is wanted")

    def test_a_folder_that_cannot_be_written(self):
        self.wedge()
        self.camera((4, -5, 3))
        (self.folder / "file").write_text("")
        self.scene.render.filepath = str(self.folder / "file" / "render_")
        self.refused("cannot be written")

    def test_a_style_that_is_not_there(self):
        self.wedge()
        self.camera((4, -5, 3))
        self.scene.lineatlas.style_file = str(self.folder / "none.toml")
        self.refused("none.toml")

    def test_no_opengl(self):
        self.wedge()
        self.camera((4, -5, 3))
        lineatlas = library.load()
        missing = lineatlas.DeviceError("there is no libEGL.so.1")
        with unittest.mock.patch.object(lineatlas.Renderer, "draw", side_effect=missing):
            self.refused("a picture of the lines needs OpenGL .there is no libEGL.so.1.; SVG and Grease Pencil do not")

    def test_no_package(self):
        self.wedge()
        self.camera((4, -5, 3))
        hidden = {name: None for name in sys.modules if name.split(".")[0] == "lineatlas"}
        with unittest.mock.patch.dict(sys.modules, hidden):
            del sys.modules["lineatlas"]
            before = [path for path in sys.path]
            sys.path[:] = [path for path in sys.path if not (pathlib.Path(path) / "lineatlas").is_dir()]
            try:
                with unittest.mock.patch.dict(os.environ, {"LINEATLAS_PYTHONPATH": ""}):
                    self.refused("the Python package lineatlas cannot be imported")
            finally:
                sys.path[:] = before

    def test_the_folder_of_the_preferences_comes_first(self):
        package = self.folder / "lineatlas"
        package.mkdir()
        (package / "__init__.py").write_text("__version__ = 'of the preferences'")
        preferences = bpy.context.preferences.addons["lineatlas_blender"].preferences
        preferences.folder = str(self.folder)
        kept = {name: module for name, module in sys.modules.items() if name.split(".")[0] == "lineatlas"}
        for name in kept:
            del sys.modules[name]
        try:
            self.assertEqual(library.load().__version__, "of the preferences")
        finally:
            preferences.folder = ""
            sys.path.remove(str(self.folder))
            del sys.modules["lineatlas"]
            sys.modules.update(kept)

    def test_an_old_blender(self):
        old = types.SimpleNamespace(app=types.SimpleNamespace(version=(2, 93, 0), version_string="2.93.0"))
        with unittest.mock.patch.dict(sys.modules, {"bpy": old}):
            specification = importlib.util.spec_from_file_location("old_addon", lineatlas_blender.__file__)
            with self.assertRaisesRegex(ImportError, "needs Blender 3.3 or newer, but this is 2.93.0"):
                specification.loader.exec_module(importlib.util.module_from_spec(specification))

    def test_a_failure_while_the_scene_is_read_leaves_the_settings_as_they_are(self):
        self.wedge()
        self.camera((4, -5, 3))
        self.scene.render.use_freestyle = True
        with unittest.mock.patch("lineatlas_blender.collector.read", side_effect=DrawingError("on purpose")):
            self.refused("on purpose")
        self.assertEqual(self.scene.render.engine, "CYCLES")
        self.assertTrue(self.scene.render.use_freestyle)
        self.assertEqual(len(collect(self.scene, bpy.context.view_layer).arrays.groups), 1)

    def test_a_script_outside_the_tests_ends_with_the_line(self):
        """As a farm runs it: the exit code says that nothing was drawn."""
        script = ("import sys; sys.path.insert(0, r'%s'); import addon_utils; addon_utils.enable('lineatlas_blender');"
                  "import bpy; bpy.context.scene.camera = None; bpy.ops.lineatlas.draw()"
                  % pathlib.Path(lineatlas_blender.__file__).parents[1])
        ended = subprocess.run([bpy.app.binary_path, "-b", "--factory-startup", "--python-exit-code", "3",
                                "--python-expr", script], capture_output=True, text=True)
        self.assertEqual(ended.returncode, 3)
        self.assertIn("has no camera", ended.stdout + ended.stderr)
