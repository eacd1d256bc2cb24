// Readers of PLY, OFF and STL compared with those of OpenMesh, on files that OpenMesh reads
// correctly.

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

// OpenMesh makes properties of uninitialised vectors. GCC warns where that code is inlined.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include "io/mesh_readers.hpp"
#include "mesh_files.hpp"

namespace lineatlas::test {
namespace {

using HalfedgeMesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using OpenMesh::IO::Options;

std::vector<std::uint32_t> corners_of(const HalfedgeMesh& mesh, OpenMesh::FaceHandle face) {
    std::vector<std::uint32_t> corners;
    for (const OpenMesh::VertexHandle corner : mesh.fv_range(face))
        corners.push_back(static_cast<std::uint32_t>(corner.idx()));
    return corners;
}

Soup read_here(const std::string& extension, const std::string& bytes) {
    const SourceFile source{.path = "a" + extension, .bytes = bytes};
    if (extension == ".ply") return read_ply(source);
    return extension == ".off" ? read_off(source) : read_stl(source);
}

/// OpenMesh does not detect by itself that an STL file is binary, or what an OFF file has besides
/// positions.
HalfedgeMesh read_by_openmesh(const std::string& extension, const std::string& bytes) {
    HalfedgeMesh mesh;
    std::istringstream stream(bytes);
    Options options = bytes.starts_with("solid") ? Options::Default : Options::Binary;
    if (extension == ".off")
        options = bytes.starts_with("OFF") ? Options::Default : Options::VertexNormal;
    EXPECT_TRUE(OpenMesh::IO::read_mesh(mesh, stream, extension, options));
    return mesh;
}

void expect_agreement(const std::string& extension, const std::string& bytes) {
    const Soup soup = read_here(extension, bytes);
    const HalfedgeMesh oracle = read_by_openmesh(extension, bytes);
    ASSERT_EQ(soup.positions.size(), oracle.n_vertices());
    for (std::size_t i = 0; i < soup.positions.size(); ++i) {
        const auto point = oracle.point(OpenMesh::VertexHandle(static_cast<int>(i)));
        ASSERT_EQ(glm::vec3(soup.positions[i]), glm::vec3(point[0], point[1], point[2]))
            << "vertex " << i;
    }
    ASSERT_EQ(soup.face_ends.size(), oracle.n_faces());
    std::size_t begin = 0;
    for (std::size_t i = 0; i < soup.face_ends.size(); ++i) {
        const std::vector<std::uint32_t> corners(soup.corners.begin() + static_cast<long>(begin),
                                                 soup.corners.begin() +
                                                     static_cast<long>(soup.face_ends[i]));
        begin = soup.face_ends[i];
        ASSERT_EQ(corners, corners_of(oracle, OpenMesh::FaceHandle(static_cast<int>(i))))
            << "face " << i;
    }
}

/// A rough field of quads, with coordinates that are floats in text too.
Model rough_field(long long quads) {
    Model model;
    for (long long x = 0; x <= quads; ++x)
        for (long long y = 0; y <= quads; ++y)
            model.points.push_back({static_cast<double>(x) / 4 - 3, static_cast<double>(-y) / 8,
                                    static_cast<double>((x * 7919 + y * 104729) % 1021) / 1024});
    for (long long x = 0; x < quads; ++x)
        for (long long y = 0; y < quads; ++y) {
            const long long first = x * (quads + 1) + y, next = first + quads + 1;
            model.faces.push_back({first, next, next + 1, first + 1});
        }
    return model;
}

std::vector<Model> models() {
    return {block_on_cube(), triangles_of(block_on_cube()), rough_field(20),
            triangles_of(rough_field(20))};
}

HalfedgeMesh halfedges_of(const Model& model) {
    HalfedgeMesh mesh;
    for (const auto& [x, y, z] : model.points)
        mesh.add_vertex(HalfedgeMesh::Point(static_cast<float>(x), static_cast<float>(y),
                                            static_cast<float>(z)));
    for (const std::vector<long long>& face : model.faces) {
        std::vector<OpenMesh::VertexHandle> corners;
        for (const long long index : face)
            corners.push_back(OpenMesh::VertexHandle(static_cast<int>(index)));
        mesh.add_face(corners);
    }
    return mesh;
}

TEST(OpenMeshReaders, AgreeOnFilesOfEveryType) {
    int tried = 0;
    for (const MeshType& type : mesh_types()) {
        if (type.extension == ".obj" || type.extension == ".om") continue;
        for (const Model& model : models()) {
            SCOPED_TRACE(type.name);
            expect_agreement(type.extension, type.write(model, {}));
            ++tried;
        }
    }
    EXPECT_EQ(tried, 7 * 4);
}

/// OFF is written without colours, because OpenMesh's reader loses its place after colours.
TEST(OpenMeshReaders, AgreeOnWhatOpenMeshWritesWithNormalsAndColours) {
    const int all = Options::VertexNormal | Options::VertexColor | Options::FaceColor;
    const std::pair<const char*, Options> kinds[] = {{".ply", all},
                                                     {".ply", all | Options::Binary},
                                                     {".ply", all | Options::Binary | Options::MSB},
                                                     {".off", Options::VertexNormal}};
    for (const Model& model : models()) {
        HalfedgeMesh mesh = halfedges_of(model);
        mesh.request_face_normals();
        mesh.request_vertex_normals();
        mesh.request_vertex_colors();
        mesh.request_face_colors();
        mesh.update_normals();
        for (const auto vertex : mesh.vertices()) mesh.set_color(vertex, {1, 2, 3});
        for (const auto face : mesh.faces()) mesh.set_color(face, {4, 5, 6});
        for (const auto& [extension, options] : kinds) {
            std::ostringstream stream;
            ASSERT_TRUE(OpenMesh::IO::write_mesh(mesh, stream, extension, options));
            SCOPED_TRACE(extension);
            expect_agreement(extension, stream.str());
        }
    }
}

} // namespace
} // namespace lineatlas::test
