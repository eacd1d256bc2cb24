#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"

namespace fs = std::filesystem;
using lineatlas::FileError;
using lineatlas::load_mesh;
using lineatlas::LoadedMesh;
using lineatlas::Mesh;

namespace {

class MeshIo : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("lineatlas_mesh_io_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path file(const std::string& name, std::string_view content) const {
        const fs::path path = folder_ / name;
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }

    LoadedMesh load(const std::string& name, std::string_view content) const {
        return load_mesh(file(name, content));
    }

    /// The message, after checking that it is one line that names the file.
    static std::string error_of(const fs::path& path) {
        try {
            load_mesh(path);
        } catch (const FileError& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            EXPECT_EQ(message.find("cannot read \"" + path.string() + "\": "), 0U) << message;
            return message;
        }
        ADD_FAILURE() << path << " was accepted";
        return {};
    }

    std::string error_of(const std::string& name, std::string_view content) const {
        return error_of(file(name, content));
    }

    fs::path folder_;
};

testing::AssertionResult has(std::string_view text, std::string_view part) {
    if (text.find(part) != std::string_view::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << '"' << text << "\" lacks \"" << part << '"';
}

double area(const Mesh& mesh) {
    double sum = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]);
        sum += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.positions[t.y]) - a,
                                            glm::dvec3(mesh.positions[t.z]) - a));
    }
    return sum;
}

void put_u32(std::string& bytes, std::uint32_t value, bool big_endian = false) {
    for (unsigned i = 0; i < 4; ++i)
        bytes += static_cast<char>(value >> (big_endian ? 24 - 8 * i : 8 * i));
}

void put_f32(std::string& bytes, float value, bool big_endian = false) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    put_u32(bytes, bits, big_endian);
}

std::string binary_stl(std::uint32_t promised, const std::vector<std::array<float, 9>>& facets,
                       const std::string& title = "made by a test") {
    std::string bytes = title + std::string(80 - title.size(), '\0');
    put_u32(bytes, promised);
    for (const auto& facet : facets) {
        bytes.append(12, '\0');
        for (const float value : facet) put_f32(bytes, value);
        bytes.append(2, '\0');
    }
    return bytes;
}

const std::vector<std::array<float, 9>> two_facets{{0, 0, 0, 1, 0, 0, 0, 1, 0},
                                                   {1, 0, 0, 1, 1, 0, 0, 1, 0}};
const std::string square_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

const std::string ply_square =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

} // namespace

// What is wrong before any format comes into it.

TEST_F(MeshIo, NamesWhatIsNoMeshFile) {
    EXPECT_TRUE(has(error_of(folder_ / "none.obj"), "no such file"));
    fs::create_directory(folder_ / "folder.obj");
    EXPECT_TRUE(has(error_of(folder_ / "folder.obj"), "it is a folder"));
    EXPECT_TRUE(has(error_of("empty.off", ""), "the file is empty"));
    EXPECT_TRUE(has(error_of("mesh.xyz", "1 2 3"),
                    "known are .obj, .ply, .stl, .off, .om, .gltf, .glb, "
                    ".3mf, .step, .stp, .iges, .igs and .brep"));
    EXPECT_TRUE(has(error_of("noextension", "1 2 3"), "known are .obj"));
    for (const char* extension : {"obj", "ply", "stl", "off", "om"})
        EXPECT_TRUE(has(error_of(std::string("picture.") + extension, "\x89PNG\r\n\x1A\n____"),
                        "it is a PNG picture"));
    EXPECT_TRUE(has(error_of("packed.ply", "\x1F\x8B____"), "gzip; unpack it"));
    EXPECT_TRUE(has(error_of("rock.obj.bz2", "BZh91AY"), "bzip2; unpack it"));
    EXPECT_TRUE(has(error_of("other.obj", "ply\nformat ascii 1.0\n" + ply_square), "type .ply"));
}

TEST_F(MeshIo, RefusesUtf16AndBinaryTextAndSkipsUtf8Mark) {
    using namespace std::string_literals;
    EXPECT_TRUE(has(error_of("wide.obj", "\xFE\xFF\0v\0 \0"s), "UTF-16"));
    EXPECT_TRUE(has(error_of("fuzz.obj", "v 3E4570711268\0\x12:"s), "binary data"));
    EXPECT_EQ(
        load("mark.obj", "\xEF\xBB\xBF" + square_vertices + "f 1 2 3\n").mesh.positions.size(), 4U);
}

TEST_F(MeshIo, TakesExtensionsInAnyCase) {
    EXPECT_EQ(load("LOUD.OBJ", square_vertices + "f 1 2 3\n").mesh.triangles.size(), 1U);
    EXPECT_EQ(load("LOUD.StL", binary_stl(2, two_facets)).mesh.triangles.size(), 2U);
}

// OBJ

TEST_F(MeshIo, ObjGroupsArePairsOfObjectAndMaterial) {
    file("paint.mtl", "newmtl red paint\nKd 1 0.25 0\nnewmtl blue\nKd 0 0 2\n");
    const LoadedMesh loaded =
        load("groups.obj", "mtllib paint.mtl\n" + square_vertices +
                               "o house\nusemtl red paint  \nf 1 2 3\ng roof\nf 1 3 4\n"
                               "usemtl blue\nf 2 3 4\no house\nusemtl red paint\nf 1 2 4\n");
    const Mesh& mesh = loaded.mesh;
    EXPECT_TRUE(loaded.notes.empty());
    ASSERT_EQ(mesh.groups.size(), 3U);
    EXPECT_EQ(mesh.triangle_group, (std::vector<std::uint32_t>{0, 1, 2, 0}));
    EXPECT_EQ(mesh.groups[0].object, "house");
    EXPECT_EQ(mesh.groups[0].material, "red paint");
    EXPECT_EQ(mesh.groups[0].color, glm::vec3(1.0F, 0.25F, 0.0F));
    EXPECT_EQ(mesh.groups[1].object, "house/roof");
    EXPECT_EQ(mesh.groups[2].material, "blue");
    EXPECT_EQ(mesh.groups[2].color, glm::vec3(0.0F, 0.0F, 1.0F));
}

TEST_F(MeshIo, ObjWithoutNamesHasNoGroups) {
    const LoadedMesh loaded = load("plain.obj", square_vertices + "f 1 2 3 4\n");
    EXPECT_TRUE(loaded.mesh.groups.empty());
    EXPECT_TRUE(loaded.mesh.triangle_group.empty());
}

TEST_F(MeshIo, ObjMissingMaterialFileIsANote) {
    const LoadedMesh loaded =
        load("a.obj", "mtllib my paint.mtl\nusemtl x\n" + square_vertices + "f 1 2 3\n");
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_TRUE(has(loaded.notes[0], "my paint.mtl"));
    EXPECT_FALSE(loaded.mesh.groups.at(0).color);
}

TEST_F(MeshIo, ObjMaterialFileNameMayHaveBlanks) {
    file("my paint.mtl", "newmtl x\r\nKd 0 1 0\r\n");
    const LoadedMesh loaded =
        load("a.obj", "mtllib .\\my paint.mtl\nusemtl x\n" + square_vertices + "f 1 2 3\n");
    EXPECT_TRUE(loaded.notes.empty());
    EXPECT_EQ(loaded.mesh.groups.at(0).color, glm::vec3(0.0F, 1.0F, 0.0F));
}

TEST_F(MeshIo, ObjLineElementsArePolylines) {
    const Mesh mesh =
        load("lines.obj", square_vertices + "l 1 2 3\nf 1 2 3\nl -1/1 -2/2\np 1 2\nl 1 \\\n2 4")
            .mesh;
    EXPECT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(mesh.polylines,
              (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {3, 2}, {0, 1, 3}}));
    EXPECT_EQ(load("only.obj", square_vertices + "l 1 2\n").mesh.polylines.size(), 1U);
}

TEST_F(MeshIo, ObjReadsWellFormedOddities) {
    const auto triangles = [&](const std::string& text) {
        return load("odd.obj", text).mesh.triangles.size();
    };
    EXPECT_EQ(triangles(square_vertices + "f -4 -3 -2\nf 1// 2// 3//\nf 1/1/1 2//2 3/3 # tail\n"),
              3U);
    EXPECT_EQ(triangles("f 1 2 3\n" + square_vertices), 1U) << "faces before their vertices";
    EXPECT_EQ(triangles("v  1   2 3  \nv\t2 3 1\nv 3 1 2 1 0.5 0.25\nf 1  2   3   "), 1U);
    EXPECT_EQ(triangles(square_vertices + "usemtl\nf 1 2 3\n"), 1U);
    const Mesh mesh = load("e.obj", "v .8e-001 -.7e+02 +5.5\nv 1e-60 1 0\nv 0 0 1\nf 1 2 3").mesh;
    EXPECT_FLOAT_EQ(mesh.positions[0].x, 0.08F);
    EXPECT_FLOAT_EQ(mesh.positions[0].y, -70.0F);
    EXPECT_FLOAT_EQ(mesh.positions[0].z, 5.5F);
    EXPECT_FLOAT_EQ(mesh.positions[1].x, 0.0F);
}

TEST_F(MeshIo, ObjLineEndsMayBeMixed) {
    const Mesh mesh =
        load("ends.obj", "v 0 0 0\r\nv 1 0 0\rv 0 1 0\nf 1 2 3\rf 3 \\\r\n2 1\rl 1 2\r").mesh;
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.polylines.size(), 1U);
}

TEST_F(MeshIo, ObjErrorsNameTheLine) {
    EXPECT_TRUE(has(error_of("a.obj", square_vertices + "\nf 1 2 3\nf 4 12 2\n"),
                    "line 7 refers to vertex 12, the file has 4"));
    EXPECT_TRUE(has(error_of("a.obj", square_vertices + "f 0 1 2\n"), "line 5 refers to vertex 0"));
    EXPECT_TRUE(has(error_of("a.obj", "f -4 -3 -2"), "line 1 refers to vertex -4, the file has 0"));
    EXPECT_TRUE(has(error_of("a.obj", square_vertices + "f 1 2 x\n"), "line 5 has \"x\""));
    EXPECT_TRUE(has(error_of("a.obj", square_vertices + "f 1 2 4294967297\n"), "line 5"));
    EXPECT_TRUE(has(error_of("a.obj", "v 0 0 zero\n"), "line 1 has \"zero\" for a coordinate"));
    EXPECT_TRUE(
        has(error_of("a.obj", "v 0 0\nv 1 1 1\n"), "line 1 gives a vertex fewer than three"));
}

TEST_F(MeshIo, ObjTruncatedInALineIsAnError) {
    EXPECT_TRUE(has(error_of("a.obj", square_vertices + "f 1 2 3\nf 25"), "middle of line 6"));
    EXPECT_TRUE(has(error_of("a.obj", square_vertices + "f 1 2 3\nv 0.5 1"), "middle of line 6"));
}

TEST_F(MeshIo, ObjWithNothingToDrawIsAnError) {
    EXPECT_TRUE(has(error_of("a.obj", "# nothing\n"), "no vertex and no face"));
    EXPECT_TRUE(has(error_of("a.obj", square_vertices), "points only"));
    EXPECT_TRUE(has(error_of("a.obj", square_vertices + "f 1\nf 2 3\n"), "can be drawn"));
}

TEST_F(MeshIo, DroppedFacesAreNoted) {
    const LoadedMesh loaded = load(
        "a.obj", square_vertices + "f 1 2\nf\nf 1 1 2\nf 1 2 3 3\nf 1 2 3\nv nan 0 0\nv 0 inf 0\n"
                                   "v 1 2 -1.#IND\nf 5 1 2\nf 1 6 2\nl 7 1\n");
    EXPECT_EQ(loaded.mesh.triangles.size(), 2U) << "the quad with a corner twice is a triangle";
    EXPECT_EQ(loaded.mesh.positions.size(), 4U);
    EXPECT_TRUE(loaded.mesh.polylines.empty());
    ASSERT_EQ(loaded.notes.size(), 4U);
    EXPECT_EQ(loaded.notes[0], "2 faces with fewer than 3 corners dropped");
    EXPECT_EQ(loaded.notes[1], "1 face with equal corners dropped");
    EXPECT_EQ(loaded.notes[2], "2 faces with coordinates that are no finite numbers dropped");
    EXPECT_TRUE(has(loaded.notes[3], "1 line "));
}

TEST_F(MeshIo, MostFacesNotFiniteIsAnError) {
    EXPECT_TRUE(has(error_of("a.obj", square_vertices + "v nan 0 0\nf 1 2 5\nf 2 3 5\nf 1 2 3\n"),
                    "2 of 3 faces"));
}

// Polygons, the same way from every type

TEST_F(MeshIo, PolygonsAreTriangulatedWithoutOverlap) {
    const auto check = [&](const std::string& vertices, const std::string& face,
                           std::size_t triangles, double whole) {
        const Mesh mesh = load("polygon.obj", vertices + face).mesh;
        EXPECT_EQ(mesh.triangles.size(), triangles) << face;
        EXPECT_NEAR(area(mesh), whole, 1e-6 * whole) << face;
    };
    check(square_vertices, "f 1 2 3 4\n", 2, 1.0);
    const std::string dart = "v 0 0 5\nv 4 0 5\nv 1 1 5\nv 0 4 5\n";
    check(dart, "f 1 2 3 4\n", 2, 4.0);
    check(dart, "f 4 3 2 1\n", 2, 4.0);
    check(dart, "f 2 3 4 1\n", 2, 4.0);
    check("v 0 0 0\nv 0 1 0\nv 0 2 0\nv 0 2 2\nv 0 0 2\n", "f 1 2 3 4 5\n", 3, 4.0);
    // A square with a square hole, joined by a bridge from 1 to 5 and back.
    check("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\n",
          "f 1 2 3 4 1 5 6 7 8 5\n", 8, 12.0);
}

TEST_F(MeshIo, StronglyConcavePolygonsAreQuickAndRight) {
    // A comb: every second corner is deep inside, so that most ears are blocked.
    constexpr int teeth = 2500;
    std::ostringstream text;
    int corners = 0;
    const auto corner = [&](double x, double y) {
        text << "v " << x << ' ' << y << " 0\n";
        ++corners;
    };
    for (int i = 0; i < teeth; ++i) {
        corner(2 * i, 10);
        corner(2 * i + 1, 10);
        corner(2 * i + 1, 1);
        corner(2 * i + 2, 1);
    }
    corner(2 * teeth, 0);
    corner(0, 0);
    text << 'f';
    for (int i = corners; i > 0; --i) text << ' ' << i;
    text << '\n';
    const Mesh mesh = load("comb.obj", text.str()).mesh;
    EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(corners - 2));
    EXPECT_NEAR(area(mesh), 2.0 * teeth + 9.0 * teeth, 1e-3);
}

// PLY

TEST_F(MeshIo, PlyEncodingsAgree) {
    const auto check = [](const LoadedMesh& loaded) {
        ASSERT_EQ(loaded.mesh.positions.size(), 4U);
        EXPECT_EQ(loaded.mesh.positions[2], glm::vec3(1, 1, 0));
        EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
    };
    check(load("ascii.ply", "ply\nformat ascii 1.0\ncomment x\n" + ply_square));
    for (const bool big : {false, true}) {
        const std::string head = ply_square.substr(0, ply_square.find("0 0 0"));
        std::string bytes =
            std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + head;
        for (const float value : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) put_f32(bytes, value, big);
        bytes += '\4';
        for (std::uint32_t i = 0; i < 4; ++i) put_u32(bytes, i, big);
        check(load("binary.ply", bytes));
        EXPECT_TRUE(has(error_of("half.ply", bytes.substr(0, bytes.size() - 6)), "truncated"));
    }
}

TEST_F(MeshIo, PlyReadsWhatOpenMeshAloneGetsWrong) {
    const LoadedMesh loaded =
        load("odd.ply",
             "ply\r\nformat ascii 1.0\r\nelement camera 1\r\nproperty list int float m\r\n"
             "element vertex 3\r\nproperty list uint8 int tags\r\nproperty short z\r\n"
             "property double x\r\nproperty int y\r\nelement face 2\r\n"
             "property list uchar float texcoord\r\nproperty list short uint vertex_index\r\n"
             "property uchar red\r\nend_header\r\n2 7 7\r\n1 9 0 0.5 0\r\n0 1 2 3\r\n0 0 1 0\r\n"
             "2 0.5 0.5 3 0 1 2 255\r\n0 3 2 1 0 255\r\n");
    EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
    EXPECT_EQ(loaded.mesh.positions.at(0), glm::vec3(0.5F, 0.0F, 0.0F));
    EXPECT_EQ(loaded.mesh.positions.at(1), glm::vec3(2, 3, 1));
    const LoadedMesh with_nan = load(
        "nan.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                   "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                   "end_header\n0 0 0\n1 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n");
    EXPECT_EQ(with_nan.mesh.triangles.size(), 1U);
    EXPECT_EQ(with_nan.mesh.positions.at(2), glm::vec3(0, 1, 0));
}

TEST_F(MeshIo, PlyFacesWithoutCorners) {
    const std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\nelement face 2\n"
                             "property list uchar int vertex_indices\nend_header\n"
                             "0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_TRUE(has(error_of("a.ply", text + "0\n0\n"),
                    "nothing in it can be drawn: 2 faces with fewer than 3 corners dropped"));
    EXPECT_EQ(load("a.ply", text + "0\n3 0 1 2\n").notes[0],
              "1 face with fewer than 3 corners dropped");
}

TEST_F(MeshIo, PlyErrors) {
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    const std::string ascii = "ply\nformat ascii 1.0\n";
    EXPECT_TRUE(has(error_of("a.ply", ascii + "end_header\n"), "no vertices"));
    EXPECT_TRUE(has(error_of("a.ply", ascii + "element vertex 1\n" + xyz + "end_header\n0 0 0\n"),
                    "points only"));
    EXPECT_TRUE(has(error_of("a.ply", ascii + "element vertex 1\n" + xyz), "no \"end_header\""));
    EXPECT_TRUE(
        has(error_of("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n" +
                                  xyz + "end_header\n" + std::string(100, '\0')),
            "promises 4000000000 elements"));
    const std::string faces =
        "element face 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n";
    EXPECT_TRUE(has(error_of("a.ply", ascii + "element vertex 1\n" + xyz + faces + "3 0 0 900\n"),
                    "face 0 refers to vertex 900, the file has 1"));
    EXPECT_TRUE(has(error_of("a.ply", ascii + "element vertex 1\n" + xyz + faces + "3 0 0 -1\n"),
                    "vertex -1"));
    EXPECT_TRUE(
        has(error_of("a.ply", ascii + "element vertex 1\n" + xyz + faces + "2000000000 0 0\n"),
            "claims"));
    EXPECT_TRUE(has(error_of("a.ply", "plyish\n"), "does not start with"));
}

// STL

TEST_F(MeshIo, StlBinaryAndAscii) {
    const Mesh binary = load("a.stl", binary_stl(2, two_facets, "solid liar")).mesh;
    EXPECT_EQ(binary.triangles.size(), 2U);
    EXPECT_EQ(binary.positions.size(), 4U) << "equal positions are welded";
    const Mesh ascii =
        load("b.stl",
             "solid a\n FACET NORMAL 0 0 1 outer loop vertex 0 0 0\nvertex 1 0 0 vertex 0 1 0\n"
             "endloop endfacet\nendsolid\nsolid facet vertex\nendsolid b\n")
            .mesh;
    EXPECT_EQ(ascii.triangles.size(), 1U);
}

TEST_F(MeshIo, StlErrors) {
    EXPECT_TRUE(has(error_of("a.stl", binary_stl(0xFFFFFFFFU, two_facets)),
                    "promises 4294967295 triangles, it has room for 2"));
    EXPECT_TRUE(
        has(error_of("a.stl", binary_stl(0, two_facets)), "promises no triangle, but data for 2"));
    EXPECT_TRUE(has(error_of("a.stl", binary_stl(0, {})), "holds no face"));
    EXPECT_TRUE(has(error_of("a.stl", binary_stl(2, two_facets).substr(0, 150)), "truncated"));
    EXPECT_TRUE(has(error_of("a.stl", "solid Empty\nendsolid Empty"), "holds no face"));
    EXPECT_TRUE(has(error_of("a.stl", "hello"), "neither binary STL"));
    const std::string facet = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 "
                              "0\nvertex 0 1 0\nendloop\nendfacet\n";
    EXPECT_TRUE(has(error_of("a.stl", facet), "truncated"));
    EXPECT_TRUE(has(error_of("a.stl", facet.substr(0, 60)), "truncated"));
    EXPECT_TRUE(has(error_of("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n"),
                    "line 4 has \"zero\""));
}

TEST_F(MeshIo, StlWithACountThatIsTooSmall) {
    const LoadedMesh all = load("a.stl", binary_stl(1, two_facets));
    EXPECT_EQ(all.mesh.triangles.size(), 2U);
    ASSERT_EQ(all.notes.size(), 1U);
    EXPECT_EQ(all.notes[0], "its header promises 1 triangle, all 2 that follow are read");
    // What others append need not be triangles.
    const LoadedMesh some = load("a.stl", binary_stl(1, two_facets) + "x");
    EXPECT_EQ(some.mesh.triangles.size(), 1U);
    ASSERT_EQ(some.notes.size(), 1U);
    EXPECT_EQ(some.notes[0], "its header promises 1 triangle, what follows is not read (51 bytes)");
}

TEST_F(MeshIo, StlDropsFacetsThatAreNotFinite) {
    auto facets = two_facets;
    facets.push_back({0, 0, INFINITY, 1, 0, 0, 0, 1, 0});
    facets.push_back({0, 0, 0, 0, 0, 0, 0, 1, 0});
    const LoadedMesh loaded = load("a.stl", binary_stl(4, facets));
    EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
    ASSERT_EQ(loaded.notes.size(), 2U);
    EXPECT_EQ(loaded.notes[0], "1 face with equal corners dropped");
    EXPECT_EQ(loaded.notes[1], "1 face with coordinates that are no finite numbers dropped");
}

// OFF

TEST_F(MeshIo, OffWithCommentsColoursAndCountsBesideTheKeyword) {
    const Mesh mesh =
        load("a.off", "# first\n#second\nCOFF\n4 2 0\n\n0 0 0 0.9 0 0 #red\n1 0 0 255 0 0\n"
                      "1 1 0#tight\n0 1 0\n\n3 0 1 2 0.9 0 0 # red\n4 0 1 2 3 1 1 1\n")
            .mesh;
    EXPECT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.triangles.size(), 3U);
    EXPECT_EQ(load("b.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2").mesh.triangles.size(), 1U);
    EXPECT_EQ(
        load("c.off", "OFF\r\n3 1\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n").mesh.triangles.size(),
        1U);
    EXPECT_EQ(load("d.off", "NOFF\n3 1 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n")
                  .mesh.positions.at(1),
              glm::vec3(1, 0, 0));
    const LoadedMesh nan =
        load("e.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1e99 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n");
    EXPECT_EQ(nan.mesh.triangles.size(), 1U);
    EXPECT_EQ(nan.notes.size(), 1U);
}

TEST_F(MeshIo, OffWithBlanksBeforeAndCountsWithoutOneBehindTheKeyword) {
    const std::string rest = " 1 0 # comment\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (const char* begin : {" \t OFF3", "\n\n OFF 3", "COFF3", "  3"})
        EXPECT_EQ(load("a.off", begin + rest).mesh.triangles.size(), 1U) << begin;
    EXPECT_TRUE(has(error_of("a.off", "  4OFF3" + rest), "more than three dimensions (4OFF3)"));
    EXPECT_TRUE(has(error_of("a.off", "  FOO 3" + rest), "keyword OFF, but with \"FOO\""));
}

TEST_F(MeshIo, OffErrors) {
    const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
    EXPECT_TRUE(
        has(error_of("a.off", "OFF\n3 2 0\n" + three + "3 0 1 2\n3 0 1\n"), "ends in face 1 of 2"));
    EXPECT_TRUE(
        has(error_of("a.off", "OFF\n3 1 0\n0.125 0.125 0.125\n1.125 0"), "ends in vertex 1 of 3"));
    EXPECT_TRUE(has(error_of("a.off", "OFF\n3 1 0\n" + three + "3 0 1 900\n"),
                    "refers to vertex 900, the file has 0 to 2"));
    EXPECT_TRUE(has(error_of("a.off", "OFF\n3 1 0\n" + three + "3 0 1 -1\n"), "vertex -1"));
    EXPECT_TRUE(
        has(error_of("a.off", "OFF\n1000000000 1 0\n" + three), "more than the file has room for"));
    EXPECT_TRUE(has(error_of("a.off", "OFF\n3 1 0\n" + three + "1000000000 0 1 2\n"),
                    "claims 1000000000 corners"));
    EXPECT_TRUE(has(error_of("a.off", "OFF\n3 0 0\n" + three), "points only"));
    EXPECT_TRUE(has(error_of("a.off", "4OFF\n3 1 0\n"), "more than three dimensions"));
    EXPECT_TRUE(has(error_of("a.off", "OFF BINARY\n...."), "binary OFF"));
    EXPECT_TRUE(has(error_of("a.off", "MESH\n3 1 0\n" + three), "keyword OFF"));
}

// OM

namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
};

template <typename OpenMeshMesh>
std::string om_square() {
    OpenMeshMesh mesh;
    std::vector<OpenMesh::VertexHandle> corners;
    for (const auto& [x, y] : {std::pair{0, 0}, {2, 0}, {2, 1}, {0, 1}})
        corners.push_back(mesh.add_vertex(typename OpenMeshMesh::Point(x, y, 3)));
    mesh.add_face(corners);
    OpenMesh::VPropHandleT<double> weight;
    mesh.add_property(weight, "weight");
    mesh.property(weight).set_persistent(true);
    mesh.request_vertex_status();
    mesh.request_vertex_normals();
    mesh.request_face_status();
    mesh.request_edge_status();
    mesh.request_halfedge_status();
    using OpenMesh::IO::Options;
    const Options everything(Options::Binary | Options::VertexNormal | Options::Status);
    std::ostringstream stream;
    EXPECT_TRUE(OpenMesh::IO::write_mesh(mesh, stream, ".om", everything));
    return stream.str();
}

} // namespace

TEST_F(MeshIo, OmOfBothPrecisionsAndVersions) {
    for (const std::string& bytes : {om_square<OpenMesh::PolyMesh_ArrayKernelT<>>(),
                                     om_square<OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>>()}) {
        const Mesh mesh = load("a.om", bytes).mesh;
        ASSERT_EQ(mesh.positions.size(), 4U);
        EXPECT_EQ(mesh.positions[2], glm::vec3(2, 1, 3));
        EXPECT_EQ(mesh.triangles.size(), 2U);
        EXPECT_NEAR(area(mesh), 2.0, 1e-9);
        for (std::size_t size = 1; size < bytes.size(); ++size) {
            // Any cut may fall behind the last chunk that matters, never inside one.
            const fs::path cut = file("cut.om", std::string_view(bytes).substr(0, size));
            try {
                EXPECT_NEAR(area(load_mesh(cut).mesh), 2.0, 1e-9) << size;
            } catch (const FileError&) {
            }
        }
    }
    std::string old("OMT\x22", 4); // version 1.2 lists vertices per face
    for (const std::uint32_t count : {3U, 1U, 3U}) put_u32(old, count);
    old += std::string("\x00\x16", 2);
    for (const float value : {0, 0, 0, 1, 0, 0, 0, 1, 0}) put_f32(old, value);
    old += static_cast<char>(0xE8); // face, topology
    old += static_cast<char>(0x80); // 32 bits
    for (const std::uint32_t index : {0U, 1U, 2U}) put_u32(old, index);
    EXPECT_EQ(load("old.om", old).mesh.triangles.size(), 1U);
    old[old.size() - 4] = 9;
    EXPECT_TRUE(has(error_of("old.om", old), "face 0 refers to vertex 9"));
}

TEST_F(MeshIo, OmErrors) {
    std::string bytes = om_square<OpenMesh::PolyMesh_ArrayKernelT<>>();
    EXPECT_TRUE(has(error_of("a.om", bytes.substr(0, 60)), "truncated"));
    bytes.replace(4, 4, "\xF0\xFF\xFF\xFF");
    EXPECT_TRUE(has(error_of("a.om", bytes), "promises 4294967280 vertices"));
    EXPECT_TRUE(has(error_of("a.om", "OMX"), "OM header"));
}

// Every byte of small files changed: whatever comes out, it is a mesh or a FileError.
TEST_F(MeshIo, DamagedFilesNeverDoMoreThanThrow) {
    std::string ply =
        "ply\nformat binary_little_endian 1.0\n" + ply_square.substr(0, ply_square.find("0 0 0"));
    for (const float value : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) put_f32(ply, value);
    ply += '\4';
    for (std::uint32_t i = 0; i < 4; ++i) put_u32(ply, i);
    const std::pair<const char*, std::string> files[] = {
        {"a.obj", square_vertices + "g a\nusemtl b\nf 1 2 3 4\nl 1 -2\n"},
        {"a.ply", ply},
        {"b.ply", "ply\nformat ascii 1.0\n" + ply_square},
        {"a.stl", binary_stl(2, two_facets)},
        {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"a.om", om_square<OpenMesh::PolyMesh_ArrayKernelT<>>()},
    };
    for (const auto& [name, content] : files)
        for (std::size_t i = 0; i < content.size(); ++i)
            for (const char byte : {'\0', '\xFF', '\x7F', '9', '\n', '-'}) {
                std::string damaged = content;
                damaged[i] = byte;
                try {
                    const Mesh mesh = load(name, damaged).mesh;
                    for (const glm::uvec3& t : mesh.triangles)
                        EXPECT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
                } catch (const FileError&) {
                }
            }
}

TEST(SharedMeshes, AllLoadOrSayWhyNot) {
    const char* variable = std::getenv("LINEATLAS_SHARED");
    const fs::path shared =
        variable != nullptr ? fs::path(variable) : fs::path(LINEATLAS_SOURCE_DIR) / "../shared";
    if (!fs::is_directory(shared / "meshes") || !fs::is_directory(shared / "hostile"))
        GTEST_SKIP() << "no folder " << shared
                     << " with meshes and hostile files; set LINEATLAS_SHARED";

    const std::pair<const char*, std::size_t> counts[] = {
        {"featuretype.STL", 3476},    {"cycloidal.ply", 43368},    {"counter.unitsmm.STL", 83750},
        {"parking_garage.obj", 6413}, {"small_house.obj", 145842}, {"koala.obj", 99994},
        {"penguin_hr.obj", 26880}};
    for (const auto& [name, triangles] : counts)
        if (fs::exists(shared / "meshes" / name)) {
            EXPECT_EQ(load_mesh(shared / "meshes" / name).mesh.triangles.size(), triangles) << name;
        }

    for (const auto& entry : fs::directory_iterator(shared / "hostile")) {
        if (entry.path().extension() == ".md") continue;
        try {
            const LoadedMesh loaded = load_mesh(entry.path());
            EXPECT_FALSE(loaded.mesh.empty()) << entry.path();
        } catch (const FileError& error) {
            EXPECT_TRUE(has(error.what(), entry.path().filename().string()));
            EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
        }
    }
}
