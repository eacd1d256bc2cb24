// PLY, STL, OFF and OM; damaged files of all formats.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include "io/model_types.hpp"
#include "mesh_io_fixture.hpp"

namespace lineatlas::test {
namespace {

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

TEST_F(MeshIo, PlyWithUnknownElementsOddTypesAndNan) {
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
    // A list is promised, but other numbers follow.
    const std::string number = ascii + "element vertex 1\n" + xyz + faces;
    EXPECT_TRUE(
        has(error_of("a.ply", number + "-0.25 0 0 0 0\n"),
            "face 0 claims -0.25 values of \"vertex_indices\", which must be a whole number "
            "from 0 to 5"));
    EXPECT_TRUE(has(error_of("a.ply", number + "2.5 0 0 0 0\n"), "claims 2.5 values"));
    EXPECT_TRUE(has(error_of("a.ply", number + "3 0 0.5 0\n"), "refers to vertex 0.5"));
    EXPECT_TRUE(has(error_of("a.ply", number + "3 0 1e300 0\n"), "refers to vertex 1e+300"));
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

TEST_F(MeshIo, StlEndsWithEndSolidInTwoWordsOrWithANote) {
    const std::string facet = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 "
                              "0\nvertex 0 1 0\nEnd Loop\nend\nfacet\n";
    const LoadedMesh two_words = load("a.stl", facet + "end solid x\n");
    EXPECT_EQ(two_words.mesh.triangles.size(), 1U);
    EXPECT_TRUE(two_words.notes.empty());
    const LoadedMesh none = load("a.stl", facet);
    EXPECT_EQ(none.mesh.triangles.size(), 1U);
    ASSERT_EQ(none.notes.size(), 1U);
    EXPECT_EQ(none.notes[0],
              "it ends without \"endsolid\" and may be cut off; 1 whole triangle read");
}

TEST_F(MeshIo, StlWeldsWhatIsZeroBeforeRounding) {
    const std::vector<std::array<float, 9>> facets{{0, 0, 0, 1, 0, 0, 0, 1, 0},
                                                   {1, 1e-40F, 0, 1, 1, 0, -0.0F, 1, -1e-40F}};
    const Mesh mesh = load("a.stl", binary_stl(2, facets)).mesh;
    ASSERT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.triangles[1], glm::uvec3(1, 3, 2));
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
    EXPECT_TRUE(has(error_of("a.stl", facet + "facet normal"), "truncated"));
    EXPECT_TRUE(has(error_of("a.stl", facet + "end face"), "\"face\" where \"solid\""));
    EXPECT_TRUE(has(error_of("a.stl", facet.substr(0, 60)), "truncated"));
    EXPECT_TRUE(has(error_of("a.stl", "solid x\n"), "truncated"));
    EXPECT_TRUE(has(error_of("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n"),
                    "line 4 has \"zero\""));
}

TEST_F(MeshIo, StlWithACountThatIsTooSmall) {
    const LoadedMesh all = load("a.stl", binary_stl(1, two_facets));
    EXPECT_EQ(all.mesh.triangles.size(), 2U);
    ASSERT_EQ(all.notes.size(), 1U);
    EXPECT_EQ(all.notes[0], "its header promises 1 triangle, all 2 that follow are read");
    // Bytes after the triangles need not be triangles.
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

TEST_F(MeshIo, OffWithBlanksBeforeAndCountsDirectlyBehindTheKeyword) {
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

TEST_F(MeshIo, OmOfBothPrecisionsAndVersions) {
    for (const std::string& bytes : {om_square<OpenMesh::PolyMesh_ArrayKernelT<>>(),
                                     om_square<OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>>()}) {
        const Mesh mesh = load("a.om", bytes).mesh;
        ASSERT_EQ(mesh.positions.size(), 4U);
        EXPECT_EQ(mesh.positions[2], glm::vec3(2, 1, 3));
        EXPECT_EQ(mesh.triangles.size(), 2U);
        EXPECT_NEAR(area(mesh), 2.0, 1e-9);
        for (std::size_t size = 1; size < bytes.size(); ++size) {
            // A file may be cut after the last chunk that matters, but not within such a chunk.
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

// Every byte of small files is changed. The result must be a mesh or a FileError.
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

// Lists of types that are written by hand

std::vector<std::string_view> types_missing_in(const std::string& text) {
    std::vector<std::string_view> missing;
    const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    for (const ModelType& type : model_types) {
        const auto is_word = [&](std::size_t at) {
            return !is_letter(text[at - 1]) && !is_letter(text[at + type.name.size()]);
        };
        std::size_t at = text.find(type.name, 1);
        while (at != std::string::npos && !is_word(at)) at = text.find(type.name, at + 1);
        if (at == std::string::npos) missing.push_back(type.name);
    }
    return missing;
}

TEST(ModelTypes, AreInAllLists) {
    for (const char* file :
         {"README.md", "docs/input.md", "packaging/lineatlas.1", "host/include/lineatlas/io.hpp"}) {
        std::stringstream text;
        text << std::ifstream{fs::path{LINEATLAS_SOURCE_DIR} / file}.rdbuf();
        EXPECT_EQ(types_missing_in(text.str()), std::vector<std::string_view>{}) << file;
    }
    EXPECT_EQ(types_missing_in(" " + model_type_names() + " "), std::vector<std::string_view>{});
    EXPECT_EQ(types_missing_in(" OBJ, PLY, STL, OFF, glTF, GLB, 3MF, STEP, IGES, BREP, OMEGA "),
              std::vector<std::string_view>{"OM"});
}

} // namespace
} // namespace lineatlas::test
