"""What becomes of the package when its process forks or ends while a thread draws."""

import os
import pathlib
import signal
import subprocess
import sys
import unittest

import lineatlas
from support import FolderTest

FORK = """
import os, sys, lineatlas
from support import cube
{before}
child = os.fork()
if child == 0:
    try:
        {inside}
    except lineatlas.DeviceError as error:
        print(error)
    sys.stdout.flush()
    os._exit(0)  # because exit() of a forked process waits for ever for threads of Mesa 26.1
print("ended as", os.waitpid(child, 0)[1])
print("parent", lineatlas.draw(cube(), size=(40, 30)).shape)
"""

DAEMON = """
import threading, lineatlas
scene = lineatlas.scene("clevis")
drawn = threading.Event()

def draw():
    while True:
        lineatlas.draw(scene.mesh, view=scene.view(0), size=(300, 200))
        drawn.set()

for _ in range(2):
    threading.Thread(target=draw, daemon=True).start()
drawn.wait()
"""


def run(program: str) -> subprocess.CompletedProcess:
    """The program's end; one that hangs is killed with its children."""
    with subprocess.Popen([sys.executable, "-c", program], text=True, start_new_session=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          cwd=pathlib.Path(__file__).parent) as process:
        try:
            said, errors = process.communicate(timeout=120)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            raise
    return subprocess.CompletedProcess(program, process.returncode, said, errors)


class Fork(unittest.TestCase):
    def check_refused(self, before: str, inside: str) -> None:
        done = run(FORK.format(before=before, inside=inside))
        lines = done.stdout.splitlines()
        self.assertEqual(lines[1:], ["ended as 0", "parent (30, 40, 4)"], done.stdout + done.stderr)
        self.assertIn("forked from one that had used OpenGL or OpenCL", lines[0])
        self.assertIn('multiprocessing.get_context("spawn")', lines[0])

    def test_a_child_of_one_that_has_drawn(self) -> None:
        self.check_refused("lineatlas.draw(cube(), size=(40, 30))", "lineatlas.draw(cube())")

    def test_a_renderer_of_the_parent(self) -> None:
        before = "kept = lineatlas.Renderer(cube())"
        self.check_refused(before, "kept.close(); kept.draw()")
        self.check_refused(before, "kept.intervals()")

    def test_a_child_of_one_that_has_listed_devices(self) -> None:
        self.check_refused("lineatlas.devices()", "lineatlas.draw(cube())")

    def test_a_child_draws_where_its_parent_has_not(self) -> None:
        done = run(FORK.format(before="mesh = cube()",
                               inside="print(lineatlas.draw(mesh, size=(40, 30)).shape)"))
        self.assertEqual(done.stdout.splitlines(),
                         ["(30, 40, 4)", "ended as 0", "parent (30, 40, 4)"], done.stderr)


class End(unittest.TestCase):
    def test_while_daemon_threads_draw(self) -> None:
        for _ in range(3):
            done = run(DAEMON)
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_what_is_drawn_after_that(self) -> None:
        """By what Python calls last; it was registered before."""
        done = run("import atexit\n"
                   "atexit.register(lambda: print(lineatlas.draw(cube(), size=(40, 30)).shape))\n"
                   "import lineatlas\nfrom support import cube\n")
        self.assertEqual((done.returncode, done.stdout), (0, "(30, 40, 4)\n"), done.stderr)


class DamagedModels(FolderTest):
    def test_what_crashes_their_reader_does_not_end_python(self) -> None:
        inputs = pathlib.Path(__file__).parents[2] / "tests/fuzz/inputs"
        crashes = 0
        for sound in (inputs / "step/pin.step", inputs / "iges/pin.iges", inputs / "brep/pin.brep"):
            try:
                self.assertGreater(len(lineatlas.load(sound).triangles), 0)
            except lineatlas.FileError as error:
                if "install the package lineatlas-brep" in str(error):
                    self.skipTest(str(error))
                raise
            lines = sound.read_bytes().splitlines(keepends=True)
            damaged = self.folder / sound.name
            for i in range(0, len(lines), len(lines) // 12):
                damaged.write_bytes(b"".join(lines[:i] + lines[i + 1:]))
                try:
                    lineatlas.load(damaged)
                except lineatlas.FileError as error:
                    crashes += "its reader crashed" in str(error)
        self.assertGreater(crashes, 0)

    def test_their_limits_are_arguments(self) -> None:
        pin = pathlib.Path(__file__).parents[2] / "tests/fuzz/inputs/step/pin.step"
        with self.assertRaisesRegex(lineatlas.FileError, "; read_seconds allows more$|install the package"):
            lineatlas.load(pin, read_seconds=0.001)
        with self.assertRaisesRegex(lineatlas.UsageError, "^read_memory must be from 0 to 1e6$"):
            lineatlas.load(pin, read_memory=-1)


if __name__ == "__main__":
    unittest.main()
