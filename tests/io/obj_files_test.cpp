// Mesh files of any format, and OBJ.
#include <algorithm>
#include <cmath>
#include <string>

#include "mesh_io_fixture.hpp"

namespace lineatlas::test {
namespace {

// Errors that do not depend on the format.

TEST_F(MeshIo, NamesWhatIsNoMeshFile) {
    EXPECT_TRUE(has(error_of(folder_.path() / "none.obj"), "no such file"));
    fs::create_directory(folder_.path() / "folder.obj");
    EXPECT_TRUE(has(error_of(folder_.path() / "folder.obj"), "it is a folder"));
    EXPECT_TRUE(has(error_of("empty.off", ""), "the file is empty"));
    EXPECT_TRUE(has(error_of("mesh.xyz", "1 2 3"),
                    "known are .obj, .ply, .stl, .off, .om, .gltf, .glb, "
                    ".3mf, .step, .stp, .iges, .igs, .brep and .brp"));
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

// Polygons are cut in the same way for every type

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
    // A comb. Every second corner is deep inside, so that most ears are blocked.
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

} // namespace
} // namespace lineatlas::test
