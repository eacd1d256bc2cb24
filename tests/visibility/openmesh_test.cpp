// Meshes of OpenMesh (lineatlas/openmesh.hpp): their lines, and the way from lines back to edges.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

// OpenMesh makes properties of uninitialised vectors. GCC warns where that code is inlined.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "lineatlas/error.hpp"
#include "lineatlas/openmesh.hpp"
#include "lineatlas/visibility.hpp"

namespace lineatlas {
namespace {

using Polygons = OpenMesh::PolyMesh_ArrayKernelT<>;
using Triangles = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;

template <class HalfedgeMesh>
FaceHandle add_face(HalfedgeMesh& mesh, const std::vector<int>& corners) {
    std::vector<VertexHandle> handles;
    for (const int corner : corners) handles.emplace_back(corner);
    return mesh.add_face(handles);
}

/// A cube from 0 to 1, of quads or triangles, depending on the type of the mesh.
template <class HalfedgeMesh>
HalfedgeMesh cube(double far = 0) {
    using Point = typename HalfedgeMesh::Point;
    using Scalar = typename HalfedgeMesh::Scalar;
    HalfedgeMesh mesh;
    for (unsigned i = 0; i < 8; ++i)
        mesh.add_vertex(Point(static_cast<Scalar>(far + (i & 1U)),
                              static_cast<Scalar>(far + (i >> 1U & 1U)),
                              static_cast<Scalar>(far + (i >> 2U))));
    for (const auto& quad : {std::vector<int>{0, 2, 3, 1},
                             {4, 5, 7, 6},
                             {0, 1, 5, 4},
                             {2, 6, 7, 3},
                             {0, 4, 6, 2},
                             {1, 3, 7, 5}})
        add_face(mesh, quad);
    return mesh;
}

/// A flat square of quads x quads squares in z = 0.
Polygons grid(int quads) {
    Polygons mesh;
    for (int y = 0; y <= quads; ++y)
        for (int x = 0; x <= quads; ++x)
            mesh.add_vertex({static_cast<float>(x), static_cast<float>(y), 0});
    for (int y = 0; y < quads; ++y)
        for (int x = 0; x < quads; ++x) {
            const int first = y * (quads + 1) + x, above = first + quads + 1;
            add_face(mesh, {first, first + 1, above + 1, above});
        }
    return mesh;
}

template <class HalfedgeMesh>
std::array<int, 2> ends_of(const HalfedgeMesh& mesh, EdgeHandle edge) {
    const auto halfedge = mesh.halfedge_handle(edge, 0);
    const int from = mesh.from_vertex_handle(halfedge).idx();
    const int to = mesh.to_vertex_handle(halfedge).idx();
    return {std::min(from, to), std::max(from, to)};
}

/// The numbers of the edges that lines of these kinds run along; each line has one.
template <class HalfedgeMesh>
std::multiset<int> edges_of(const HalfedgeMesh& source, const OpenMeshModel<HalfedgeMesh>& model,
                            const LineSet& lines, LineKindMask kinds) {
    std::multiset<int> edges;
    for (std::size_t i = 0; i < lines.segments.size(); ++i) {
        const LineKind kind{lines.segments[i].tag & LA_TAG_KIND_MASK};
        if ((mask_of(kind) & kinds) == 0) continue;
        const LineSource& line = lines.sources[i];
        const EdgeHandle edge = model.edge(line);
        EXPECT_TRUE(edge.is_valid());
        if (!edge.is_valid()) continue;
        const std::array<int, 2> ends{static_cast<int>(std::min(line.from, line.to)),
                                      static_cast<int>(std::max(line.from, line.to))};
        EXPECT_EQ(ends_of(source, edge), ends);
        edges.insert(edge.idx());
    }
    return edges;
}

TEST(OpenMeshModel, EveryCreaseOfACubeIsAnEdge) {
    const auto polygons = cube<Polygons>();
    const OpenMeshModel model{polygons};
    EXPECT_EQ(model.mesh().triangles.size(), 12U);
    EXPECT_EQ(model.origin(), glm::dvec3(0));
    std::multiset<int> all;
    for (int i = 0; i < 12; ++i) all.insert(i);
    const LineSet lines = extract_lines(model.mesh());
    EXPECT_EQ(edges_of(polygons, model, lines, all_line_kinds), all);

    const auto triangles = cube<Triangles>();
    const OpenMeshModel triangle_model{triangles};
    const LineSet of_triangles = extract_lines(triangle_model.mesh());
    EXPECT_EQ(edges_of(triangles, triangle_model, of_triangles, all_line_kinds).size(), 12U);
}

TEST(OpenMeshModel, IntervalsKnowTheirEdges) {
    const auto source = cube<Polygons>();
    const OpenMeshModel model{source};
    const LineSet lines = extract_lines(model.mesh());
    LineVisibility visibility{lines};
    const Camera camera =
        make_camera({.eye = {4, 3, 5}, .target = {0.5F, 0.5F, 0.5F}}, {400, 300}, lines.bounds);
    std::set<int> seen;
    for (const Interval& piece : visibility.find(camera)) {
        const EdgeHandle edge = model.edge(lines.sources[piece.segment]);
        ASSERT_TRUE(edge.is_valid());
        seen.insert(edge.idx());
        EXPECT_NE(ends_of(source, edge)[0], 0) << "the corner that the cube hides";
    }
    EXPECT_EQ(seen.size(), 9U) << "all but the three at that corner";
}

TEST(OpenMeshModel, PolygonsMayBeConcave) {
    Polygons source;
    for (const auto& [x, y] : {std::pair{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}})
        source.add_vertex({static_cast<float>(x), static_cast<float>(y), 0});
    const FaceHandle face = add_face(source, {0, 1, 2, 3, 4});
    const OpenMeshModel model{source};
    double area = 0;
    for (std::uint32_t i = 0; i < model.mesh().triangles.size(); ++i) {
        EXPECT_EQ(model.face(i), face);
        const glm::uvec3 t = model.mesh().triangles[i];
        const auto& p = model.mesh().positions;
        const glm::vec3 twice = glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]);
        EXPECT_GT(twice.z, 0) << "in the polygon's winding";
        area += 0.5 * twice.z;
    }
    EXPECT_DOUBLE_EQ(area, 10);
    for (const auto& [from, to] : {std::pair{0U, 3U}, {1U, 3U}})
        EXPECT_FALSE(model.edge({.from = from, .to = to, .triangle = 0}).is_valid())
            << "within the polygon";
    EXPECT_FALSE(model.edge({}).is_valid());
    EXPECT_FALSE(model.edge({.from = 0, .to = 9, .triangle = 0}).is_valid());
    EXPECT_FALSE(model.edge({.from = 0, .to = 1}).is_valid()) << "a line of the program's own";
}

TEST(OpenMeshModel, FeaturesAreCreases) {
    Polygons source = grid(4);
    source.request_edge_status();
    std::multiset<int> marked;
    for (const auto edge : source.edges()) {
        if (source.is_boundary(edge) || edge.idx() % 3 != 0) continue;
        source.status(edge).set_feature(true);
        marked.insert(edge.idx());
    }
    ASSERT_GT(marked.size(), 3U);
    const OpenMeshModel model{source};
    ASSERT_EQ(model.mesh().known_edges.size(), marked.size());
    for (const KnownEdge& known : model.mesh().known_edges) {
        EXPECT_EQ(known.kind, KnownEdge::Kind::marked);
        EXPECT_TRUE(marked.contains(static_cast<int>(known.edge)));
    }
    const LineSet lines = extract_lines(model.mesh());
    EXPECT_EQ(edges_of(source, model, lines, mask_of(LineKind::crease)), marked);
    EXPECT_EQ(edges_of(source, model, lines, mask_of(LineKind::boundary)).size(), 16U);

    const OpenMeshModel without{source, {.features = false}};
    EXPECT_TRUE(without.mesh().known_edges.empty());
}

TEST(OpenMeshModel, GroupsByAPropertyOfFaces) {
    Polygons source = grid(4);
    OpenMesh::FPropHandleT<int> part;
    OpenMesh::FPropHandleT<std::string> material;
    source.add_property(part);
    source.add_property(material);
    for (const auto face : source.faces()) {
        const bool left = face.idx() % 4 < 2;
        source.property(part, face) = left ? 7 : -3;
        source.property(material, face) = left ? "steel" : "brass";
    }
    OpenMeshModel model{source};
    EXPECT_TRUE(model.mesh().groups.empty());
    const auto expect_groups = [&](const std::string& left, const std::string& right) {
        const Mesh& mesh = model.mesh();
        ASSERT_EQ(mesh.groups.size(), 2U);
        ASSERT_EQ(mesh.triangle_group.size(), mesh.triangles.size());
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
            EXPECT_EQ(mesh.groups[mesh.triangle_group[i]].material,
                      model.face(i).idx() % 4 < 2 ? left : right);
        const LineSet lines = extract_lines(mesh);
        EXPECT_EQ(edges_of(source, model, lines, mask_of(LineKind::material)).size(), 4U);
    };
    model.set_groups(part);
    expect_groups("7", "-3");
    model.set_groups(material); // in place of the earlier groups
    expect_groups("steel", "brass");
}

TEST(OpenMeshModel, DeletedAndHiddenFacesAreLeftOut) {
    Polygons source = cube<Polygons>();
    source.request_face_status();
    source.request_edge_status();
    source.request_vertex_status();
    source.request_halfedge_status();
    source.delete_face(FaceHandle(0), true);
    source.status(FaceHandle(3)).set_hidden(true);
    const OpenMeshModel model{source};
    ASSERT_EQ(model.mesh().triangles.size(), 8U);
    std::set<int> faces;
    for (std::uint32_t i = 0; i < 8; ++i) faces.insert(model.face(i).idx());
    EXPECT_EQ(faces, (std::set<int>{1, 2, 4, 5}));
    const LineSet lines = extract_lines(model.mesh());
    edges_of(source, model, lines, all_line_kinds);
    // The hidden face and the deleted one had a common edge, which is gone.
    EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 6U);
    EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], 5U);
}

TEST(OpenMeshModel, NormalsOfCorners) {
    Polygons source = cube<Polygons>();
    EXPECT_TRUE(OpenMeshModel{source}.mesh().corner_normals.empty());
    source.request_face_normals();
    source.request_halfedge_normals();
    source.request_vertex_normals();
    source.update_normals();
    for (auto halfedge : source.halfedges()) { // lengths by corner tell corners apart
        const auto corner = static_cast<float>(source.to_vertex_handle(halfedge).idx());
        source.set_normal(halfedge, {corner, 1, 0});
    }
    source.set_normal(*source.cfh_iter(FaceHandle(0)), {0, 0, 0});

    const OpenMeshModel model{source};
    const Mesh& mesh = model.mesh();
    ASSERT_EQ(mesh.corner_normals.size(), 3 * mesh.triangles.size());
    const auto zero_at =
        static_cast<std::uint32_t>(source.to_vertex_handle(*source.cfh_iter(FaceHandle(0))).idx());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t corner = mesh.triangles[i][k];
            const glm::vec3 normal = mesh.corner_normals[3 * i + static_cast<unsigned>(k)];
            const bool is_zero = model.face(i) == FaceHandle(0) && corner == zero_at;
            const glm::vec3 expected =
                is_zero ? glm::vec3{0}
                        : glm::normalize(glm::vec3{static_cast<float>(corner), 1, 0});
            EXPECT_LT(glm::distance(normal, expected), 1e-6F) << i << ' ' << k;
        }

    const Mesh by_vertices = OpenMeshModel{source, {.normals = OpenMeshNormals::vertices}}.mesh();
    for (std::uint32_t i = 0; i < by_vertices.triangles.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 out =
                by_vertices.positions[by_vertices.triangles[i][k]] - glm::vec3{0.5F};
            EXPECT_LT(glm::distance(by_vertices.corner_normals[3 * i + static_cast<unsigned>(k)],
                                    glm::normalize(out)),
                      1e-3F);
        }
    EXPECT_TRUE(
        OpenMeshModel(source, {.normals = OpenMeshNormals::none}).mesh().corner_normals.empty());
}

TEST(OpenMeshModel, FarFromZeroItIsAboutAnOrigin) {
    auto source = cube<Triangles>(1e8 + 0.25);
    source.add_vertex({0, 0, 0}); // a vertex without faces
    const OpenMeshModel model{source};
    EXPECT_GT(model.origin().x, 9e7);
    ASSERT_EQ(model.mesh().positions.size(), 9U);
    for (int i = 0; i < 8; ++i)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(model.mesh().positions[static_cast<std::size_t>(i)][axis] +
                          model.origin()[axis],
                      source.point(VertexHandle(i))[axis]);
}

TEST(OpenMeshModel, WithoutFacesItHasPositionsAlone) {
    Polygons source;
    EXPECT_TRUE(OpenMeshModel{source}.mesh().positions.empty());
    for (int i = 0; i < 4; ++i) source.add_vertex({static_cast<float>(i), 0, 0});
    const OpenMeshModel model{source};
    EXPECT_EQ(model.mesh().positions.size(), 4U);
    EXPECT_TRUE(model.mesh().empty());
}

TEST(OpenMeshModel, PolygonsOfOnesOwnAreChecked) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    add_polygon(mesh, std::vector<std::uint32_t>{0, 1, 2, 3});
    add_polygon(mesh, std::vector<std::uint32_t>{0, 1});
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_THROW(add_polygon(mesh, std::vector<std::uint32_t>{0, 1, 4}), UsageError);
    mesh.positions.assign(6, glm::vec3{std::numeric_limits<float>::quiet_NaN()});
    add_polygon(mesh, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
    EXPECT_THROW(extract_lines(mesh), UsageError);
}

} // namespace
} // namespace lineatlas
