"""The pieces of C++ in README, docs and public headers compile against these headers, each as the body of a function."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from documents import PAGES, ROOT, blocks

HEADERS = sorted((ROOT / "host/include/lineatlas").glob("*.hpp"))

# What the pieces take for granted: what a program of the reader's has.
PROGRAM = """
#include <atomic>
#include <fstream>
#include <iostream>
#include <optional>
#include <vector>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
""" + "".join(f"#include <lineatlas/{header.name}>\n" for header in HEADERS) + """
using namespace lineatlas;

struct Program {
    Mesh mesh, bolt_mesh;
    LineSet lines;
    Renderer renderer;
    LineVisibility visibility;
    FrameOptions options;
    Style style;
    Camera camera;
    View door, roof;
    std::vector<FrameProfile> profiles;
    glm::mat4 view, projection;
    glm::ivec2 size;
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<glm::vec3> new_positions, mesh_positions;
    OpenMesh::PolyMesh_ArrayKernelT<> part;
    OpenMesh::FPropHandleT<int> material_of_face;
    std::uint32_t first_vertex, depth_texture, framebuffer;
    int width, height, x, y, frames;
    bool stop;
    bool show(float);
    bool show(int, int);
"""


def examples(header):
    """The examples in the comments of a public header."""
    for block in re.findall(r"^ */// @code{\.cpp}\n(.*?)^ */// @endcode$", header.read_text(), re.MULTILINE | re.DOTALL):
        yield re.sub(r"^ */// ?", "", block, flags=re.MULTILINE)


def program(pieces):
    """A translation unit with every piece as a member function."""
    functions = []
    for number, piece in enumerate(pieces):
        body = re.sub(r"^(#include.*|using namespace.*)$", "", piece, flags=re.MULTILINE)
        body = re.sub(r"(\)) \.\.\.", r"\1 {}", body)  # what a loop does is the reader's
        body = re.sub(r"^( *)\.\.\.$", "", body, flags=re.MULTILINE)
        functions.append(f"void piece_{number}() {{\n{body}\n}}\n")
    return PROGRAM + "".join(functions) + "};\n"


def compile_(text):
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as file:
        file.write(text)
        file.flush()
        folders = [f"-I{ROOT / folder}" for folder in ("host/include", "kernels")]
        command = [os.environ["LINEATLAS_CXX"], "-std=c++20", "-fsyntax-only", "-DGLM_FORCE_XYZW_ONLY", *folders, file.name]
        return subprocess.run(command, capture_output=True, text=True, check=False)


class Snippets(unittest.TestCase):
    def test_every_piece_compiles(self):
        pieces = [block for page in PAGES for block in blocks(page.read_text(), "cpp") if "int main" not in block]
        self.assertGreater(len(pieces), 12)
        done = compile_(program(pieces))
        self.assertEqual(0, done.returncode, done.stderr)

    def test_every_header_has_an_example_that_compiles(self):
        without = [header.name for header in HEADERS if not list(examples(header))]
        self.assertEqual(["export.hpp"], without)  # it has nothing to call
        done = compile_(program([piece for header in HEADERS for piece in examples(header)]))
        self.assertEqual(0, done.returncode, done.stderr)

    def test_every_header_has_a_page_in_the_reference(self):
        self.assertEqual([], [header.name for header in HEADERS if "/// @file\n" not in header.read_text()])

    def test_a_piece_that_is_wrong_is_found(self):
        done = compile_(program(["options.nothing = 1;"]))
        self.assertNotEqual(0, done.returncode)
        self.assertIn("nothing", done.stderr)


if __name__ == "__main__":
    unittest.main()
