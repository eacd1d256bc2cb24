"""A renderer that is kept: threads, memory, errors, and its end."""

import ctypes
import gc
import os
import pathlib
import subprocess
import sys
import threading
import unittest

import numpy as np

import lineatlas
from support import CUBE_VIEW, cube


def resident_bytes() -> int:
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * 4096


def views(count: int) -> list:
    return [lineatlas.View((4 * np.cos(a), 2, 4 * np.sin(a)), (0.5, 0.5, 0.5))
            for a in np.linspace(0, 6, count)]


class Threads(unittest.TestCase):
    def draw_all(self, renderer: lineatlas.Renderer, pictures: list) -> None:
        for view in views(10):
            pictures.append(renderer.draw(size=(160, 120), view=view))

    def run_threads(self, jobs: list) -> None:
        threads = [threading.Thread(target=job, args=arguments) for job, *arguments in jobs]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(120)
            self.assertFalse(thread.is_alive())

    def test_two_renderers_and_one_of_both(self) -> None:
        expected: list = []
        shared = lineatlas.Renderer(cube())
        self.draw_all(shared, expected)
        own: list = [[], []]
        both: list = [[], []]

        def make_and_draw(pictures: list) -> None:
            with lineatlas.Renderer(cube()) as renderer:
                self.draw_all(renderer, pictures)

        self.run_threads([(make_and_draw, own[0]), (make_and_draw, own[1]),
                          (self.draw_all, shared, both[0]), (self.draw_all, shared, both[1])])
        for pictures in own + both:
            self.assertEqual(len(pictures), len(expected))
            for picture, right in zip(pictures, expected):
                np.testing.assert_array_equal(picture, right)

    def test_others_run_while_it_draws(self) -> None:
        """The interpreter's lock is not held: this thread counts on."""
        scene = lineatlas.scene("house")
        done = threading.Event()

        def draw() -> None:
            lineatlas.draw(scene.mesh, view=scene.view(0))
            done.set()

        thread = threading.Thread(target=draw)
        thread.start()
        counted = 0
        while not done.wait(0.001):
            counted += 1
        thread.join()
        self.assertGreater(counted, 20)

    def test_destroyed_on_another_thread(self) -> None:
        kept = [lineatlas.Renderer(cube())]
        kept[0].draw(size=(16, 16))
        self.run_threads([(kept.clear,)])
        gc.collect()
        lineatlas.draw(cube(), size=(16, 16))


class OtherContexts(unittest.TestCase):
    """What is current in EGL, by the program's own doing, still is after each call."""

    def setUp(self) -> None:
        self.egl = ctypes.CDLL("libEGL.so.1")
        for name in ("eglGetPlatformDisplay", "eglCreateContext", "eglGetCurrentContext"):
            getattr(self.egl, name).restype = ctypes.c_void_p

    def check_calls(self, current: object, api: int) -> None:
        def check() -> None:
            self.assertEqual(self.egl.eglGetCurrentContext(), current)
            self.assertEqual(self.egl.eglQueryAPI(), api)
        renderer = lineatlas.Renderer(cube())
        check()
        renderer.draw(size=(16, 16))
        check()
        with self.assertRaises(lineatlas.FileError):
            renderer.draw(size=(16, 16), style=lineatlas.Style(pen="./missing.png"))
        check()
        renderer.close()
        check()

    def test_none(self) -> None:
        self.check_calls(None, self.egl.eglQueryAPI())

    def test_own(self) -> None:
        surfaceless, opengl_es = 0x31DD, 0x30A0
        display = ctypes.c_void_p(self.egl.eglGetPlatformDisplay(surfaceless, None, None))
        self.assertTrue(self.egl.eglInitialize(display, None, None))
        self.egl.eglBindAPI(opengl_es)
        version_2 = (ctypes.c_int * 3)(0x3098, 2, 0x3038)
        context = self.egl.eglCreateContext(display, None, None, version_2)
        self.assertTrue(self.egl.eglMakeCurrent(display, None, None, ctypes.c_void_p(context)))
        try:
            self.check_calls(context, opengl_es)
        finally:
            self.egl.eglMakeCurrent(display, None, None, None)
            self.egl.eglDestroyContext(display, ctypes.c_void_p(context))


class Memory(unittest.TestCase):
    def grown_by(self, job: object, count: int) -> int:
        """Bytes that the process grows by in the best of four times `count` runs: a leak is in all
        of them, a thread whose heap grows once is not."""
        sizes = []
        for _ in range(5):
            for _ in range(count):
                job()
            gc.collect()
            sizes.append(resident_bytes())
        return min(after - before for before, after in zip(sizes, sizes[1:]))

    def test_a_kept_renderer_does_not_grow(self) -> None:
        with lineatlas.Renderer(cube()) as renderer:
            def job() -> None:
                renderer.draw(size=(320, 240), view=CUBE_VIEW, style="pencil")
                renderer.intervals(size=(320, 240), view=CUBE_VIEW)
            picture = 320 * 240 * 4
            self.assertLess(self.grown_by(job, 50), picture)

    def test_meshes_are_given_back(self) -> None:
        positions = np.random.default_rng(1).random((300_000, 3), np.float32)
        size = positions.nbytes
        self.assertLess(self.grown_by(lambda: lineatlas.Mesh(positions).positions, 10), size)


class Life(unittest.TestCase):
    def test_closed(self) -> None:
        renderer = lineatlas.Renderer(cube())
        renderer.close()
        renderer.close()
        with self.assertRaisesRegex(lineatlas.UsageError, "closed"):
            renderer.draw(view=CUBE_VIEW)
        with self.assertRaisesRegex(lineatlas.UsageError, "closed"):
            _ = renderer.description

    def test_another_model(self) -> None:
        with lineatlas.Renderer(lineatlas.scene("clevis").mesh) as renderer:
            renderer.draw(size=(100, 80))
            renderer.set_model(cube())
            np.testing.assert_array_equal(renderer.draw(size=(100, 80)),
                                          lineatlas.draw(cube(), size=(100, 80)))

    def test_goes_on_after_an_error(self) -> None:
        with lineatlas.Renderer(cube()) as renderer:
            before = renderer.draw(size=(100, 80))
            with self.assertRaisesRegex(lineatlas.UsageError, "use a smaller size, or"):
                renderer.draw(size=(70000, 80))
            with self.assertRaises(lineatlas.FileError):
                renderer.draw(style=lineatlas.Style(pen="./missing.png"))
            with self.assertRaises(lineatlas.FileError):
                renderer.set_model("missing.obj")
            np.testing.assert_array_equal(renderer.draw(size=(100, 80)), before)

    def test_intervals_are_the_same_before_and_after_a_picture(self) -> None:
        """The first are found without OpenGL, the others by the renderer of pictures."""
        scene = lineatlas.scene("clevis")
        with lineatlas.Renderer(scene.mesh) as renderer:
            self.assertNotIn("sharing", renderer.description)
            before = renderer.intervals(view=scene.view(0), hidden=True)
            renderer.draw(size=(40, 30))
            self.assertIn("sharing", renderer.description)
            after = renderer.intervals(view=scene.view(0), hidden=True)
            self.assertGreater(len(before), 50)
            np.testing.assert_array_equal(before, after)

    def test_interop_is_looked_at_when_it_is_given(self) -> None:
        with self.assertRaisesRegex(lineatlas.UsageError, "interop"):
            lineatlas.Renderer(cube(), interop="telepathy")
        with lineatlas.Renderer(cube(), interop="copy") as renderer:
            self.assertIn("sharing by copy", renderer.description)
            self.assertEqual(len(renderer.intervals(view=CUBE_VIEW)),
                             len(lineatlas.intervals(cube(), view=CUBE_VIEW)))

    def test_cpp_device(self) -> None:
        with lineatlas.Renderer(cube(), compute="cpp") as renderer:
            self.assertIn("cpp", renderer.description)
            np.testing.assert_array_equal(renderer.draw(size=(100, 80)),
                                          lineatlas.draw(cube(), size=(100, 80)))

    def test_errors(self) -> None:
        for error, builtin in ((lineatlas.UsageError, ValueError), (lineatlas.FileError, OSError),
                               (lineatlas.DeviceError, RuntimeError),
                               (lineatlas.MismatchError, RuntimeError)):
            self.assertTrue(issubclass(error, builtin) and issubclass(error, lineatlas.Error))
        with self.assertRaisesRegex(lineatlas.UsageError, "backend"):
            lineatlas.Renderer(cube(), compute="abacus")
        with self.assertRaisesRegex(lineatlas.UsageError, "no such platform"):
            lineatlas.Renderer(cube(), device="opencl:no such platform")
        with self.assertRaisesRegex(lineatlas.UsageError, "no scene|scene"):
            lineatlas.scene("garage")
        with self.assertRaises(TypeError):
            lineatlas.draw(cube(), colour="red")

    def test_no_opencl(self) -> None:
        def run(words: str) -> subprocess.CompletedProcess[str]:
            return subprocess.run([sys.executable, "-c", "import lineatlas, support\n" + words],
                                  capture_output=True, text=True,
                                  cwd=pathlib.Path(__file__).parent,
                                  env=os.environ | {"OCL_ICD_VENDORS": "/none"})
        done = run("cube = support.cube()\n"
                   "for _ in range(3): found = len(lineatlas.intervals(cube))\n"
                   "for _ in range(3): lineatlas.Renderer(cube).draw(size=(40, 30))\n"
                   "lineatlas.draw(cube, size=(40, 30))  # draw() asks for no device\n"
                   "with lineatlas.Renderer(cube, compute='cpp') as r:\n"
                   "    print(r.description, found)\n"
                   "    r.draw(size=(40, 30))\n"
                   "    print(r.description)")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"^cpp \([^,]*\) [1-9][0-9]*\ncpp .*, sharing by .*$")
        self.assertEqual(done.stderr.count("RuntimeWarning: no OpenCL device was found"), 1,
                         done.stderr)
        done = run("try: lineatlas.Renderer(support.cube(), compute='opencl')\n"
                   "except lineatlas.DeviceError as error: print(error)")
        self.assertIn("no OpenCL device was found (on Debian", done.stdout, done.stderr)
        self.assertEqual(done.stderr, "")

    def test_an_old_driver_of_opengl(self) -> None:
        """Pictures say what is missing; intervals do without."""
        old = {"MESA_GL_VERSION_OVERRIDE": "3.3", "MESA_GLSL_VERSION_OVERRIDE": "330"}
        words = ("import lineatlas, support\n"
                 "try: lineatlas.draw(support.cube(), size=(40, 30))\n"
                 "except lineatlas.DeviceError as error: print(error)\n"
                 "print(len(lineatlas.intervals(support.cube(), view=support.CUBE_VIEW)))")
        done = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True,
                              cwd=pathlib.Path(__file__).parent, env=os.environ | old)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"^the driver offers no OpenGL 4.5 core context: [^\n]*\n9\n$")


if __name__ == "__main__":
    unittest.main()
