// Creases and boundaries compared with OpenMesh's halfedge mesh, for meshes that it can hold.

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

// OpenMesh makes properties of uninitialised vectors. GCC warns where that code is inlined.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "lines/edges.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

using HalfedgeMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

HalfedgeMesh halfedges_of(const WeldedMesh& mesh) {
    HalfedgeMesh result;
    std::vector<HalfedgeMesh::VertexHandle> vertices;
    for (const glm::vec3& v : mesh.vertices) {
        vertices.push_back(result.add_vertex(OpenMesh::Vec3d{v.x, v.y, v.z}));
    }
    for (const glm::uvec3& t : mesh.triangles) {
        const auto face = result.add_face(vertices[t.x], vertices[t.y], vertices[t.z]);
        EXPECT_TRUE(face.is_valid()) << "not a manifold";
    }
    result.request_face_normals();
    result.update_face_normals();
    return result;
}

void expect_agreement(const Mesh& mesh, float crease_angle) {
    const WeldedMesh welded = weld(mesh);
    std::vector<MeshEdge> edges = mesh_edges(welded);
    const std::vector<glm::dvec3> normals = face_normals(welded);
    replace_slivers(welded, normals, edges);
    const std::vector<double> bends = bends_of(edges, normals);
    HalfedgeMesh oracle = halfedges_of(welded);
    ASSERT_EQ(edges.size(), oracle.n_edges());

    LineOptions options;
    options.crease = crease_angle;
    options.lines = mask_of(LineKind::crease) | mask_of(LineKind::boundary);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const MeshEdge& edge = edges[i];
        const auto halfedge =
            oracle.find_halfedge(OpenMesh::VertexHandle(static_cast<int>(edge.p)),
                                 OpenMesh::VertexHandle(static_cast<int>(edge.q)));
        ASSERT_TRUE(halfedge.is_valid());
        const std::optional<LineKind> kind = classify(edge, welded, bends[i], options);
        if (oracle.is_boundary(oracle.edge_handle(halfedge))) {
            EXPECT_EQ(kind, LineKind::boundary);
            EXPECT_EQ(edge.face_b, LA_NO_FACE);
            continue;
        }
        // From p to q is the winding of face_a, so face_a is the halfedge's own face, to its left.
        EXPECT_EQ(oracle.face_handle(halfedge).idx(), static_cast<int>(edge.face_a));
        EXPECT_EQ(oracle.face_handle(oracle.opposite_halfedge_handle(halfedge)).idx(),
                  static_cast<int>(edge.face_b));
        const double angle = std::abs(oracle.calc_dihedral_angle(halfedge));
        if (std::abs(angle - crease_angle) < 1e-7) continue; // acos there, atan2 here
        EXPECT_EQ(kind == LineKind::crease, angle > crease_angle) << angle;
    }
}

TEST(OpenMeshOracle, AgreesOnRegularShapes) {
    for (const float degrees : {1.0F, 30.0F, 60.0F, 89.0F, 91.0F, 150.0F}) {
        const float angle = glm::radians(degrees);
        expect_agreement(test::with_own_corners(test::cube()), angle);
        expect_agreement(test::tetrahedron(), angle);
        for (int level = 0; level < 4; ++level) expect_agreement(test::sphere(level), angle);
        expect_agreement(test::cylinder(12, true), angle);
        expect_agreement(test::cylinder(12, false), angle);
        expect_agreement(test::open_strip(6), angle);
    }
}

TEST(OpenMeshOracle, AgreesOnRandomManifolds) {
    test::Random random{61};
    for (int round = 0; round < 30; ++round) {
        const float angle = random.between(0.02F, 2.5F);
        const glm::mat4 placement = random.placement(5);
        expect_agreement(test::moved(test::height_field(random, 12, 2), placement), angle);
        expect_agreement(
            test::moved(test::with_random_radii(test::sphere(3), random, 0.6F), placement), angle);
    }
}

/// Random triangles are left out and leave holes. A halfedge mesh refuses some triangles that touch
/// the rest only at a vertex; these are left out, too.
TEST(OpenMeshOracle, AgreesOnRandomManifoldsWithHoles) {
    test::Random random{62};
    for (int round = 0; round < 20; ++round) {
        Mesh mesh = test::height_field(random, 15, 2);
        HalfedgeMesh builder;
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) builder.add_vertex({});
        std::vector<glm::uvec3> kept;
        for (const glm::uvec3& t : mesh.triangles) {
            if (random.below(4) == 0) continue;
            const auto corner = [](std::uint32_t v) {
                return OpenMesh::VertexHandle(static_cast<int>(v));
            };
            omerr().disable();
            const bool added = builder.add_face(corner(t.x), corner(t.y), corner(t.z)).is_valid();
            omerr().enable();
            if (added) kept.push_back(t);
        }
        mesh.triangles = kept;
        expect_agreement(mesh, glm::radians(30.0F));
    }
}

} // namespace
} // namespace lineatlas
