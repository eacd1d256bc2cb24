#include "lines/edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "test_meshes.hpp"

namespace lineatlas {
namespace {

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;
using Kinds = std::map<VertexPair, std::optional<LineKind>>;

Kinds kinds_of(const Mesh& mesh, const LineOptions& options = {}) {
    const WeldedMesh welded = weld(mesh);
    std::vector<MeshEdge> edges = mesh_edges(welded);
    const std::vector<glm::dvec3> normals = face_normals(welded);
    replace_slivers(welded, normals, edges);
    const std::vector<double> bends = bends_of(edges, normals);
    Kinds kinds;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        kinds[std::minmax(edges[i].p, edges[i].q)] = classify(edges[i], welded, bends[i], options);
    }
    return kinds;
}

/// The same by position, because vertices are numbered by their first use.
std::map<std::array<float, 6>, std::optional<LineKind>> placed_kinds_of(const Mesh& mesh) {
    const WeldedMesh welded = weld(mesh);
    std::map<std::array<float, 6>, std::optional<LineKind>> placed;
    for (const auto& [edge, kind] : kinds_of(mesh)) {
        const glm::vec3 a = welded.vertices[edge.first];
        const glm::vec3 b = welded.vertices[edge.second];
        placed[{a.x, a.y, a.z, b.x, b.y, b.z}] = kind;
        placed[{b.x, b.y, b.z, a.x, a.y, a.z}] = kind;
    }
    return placed;
}

std::ptrdiff_t count(const Kinds& kinds, std::optional<LineKind> kind) {
    return std::ranges::count(kinds, kind, &Kinds::value_type::second);
}

LineOptions with_crease_angle(float angle) {
    return {.crease = angle};
}

/// Compares every edge with a map of all uses that is built in a slow way.
void expect_every_edge_once(const Mesh& mesh) {
    const WeldedMesh welded = weld(mesh);
    std::map<VertexPair, std::vector<std::pair<std::uint32_t, bool>>> uses; // face, runs downwards
    for (std::uint32_t face = 0; face < welded.triangles.size(); ++face) {
        const glm::uvec3 t = welded.triangles[face];
        for (const auto& [a, b] : {VertexPair{t.x, t.y}, {t.y, t.z}, {t.z, t.x}}) {
            uses[std::minmax(a, b)].emplace_back(face, a > b);
        }
    }
    const std::vector<MeshEdge> edges = mesh_edges(welded);
    ASSERT_EQ(edges.size(), uses.size());
    std::uint32_t last_vertex = 0;
    for (const MeshEdge& edge : edges) {
        const VertexPair key = std::minmax(edge.p, edge.q);
        EXPECT_GE(key.first, last_vertex) << "not ordered by the smaller vertex";
        last_vertex = key.first;
        ASSERT_TRUE(uses.contains(key)) << "not an edge, or there twice";
        const auto of_edge = uses[key];
        uses.erase(key);
        EXPECT_EQ(edge.face_count, of_edge.size());
        EXPECT_EQ(edge.face_a, of_edge[0].first);
        EXPECT_EQ(edge.p > edge.q, of_edge[0].second) << "not in the winding of face_a";
        if (of_edge.size() == 1) {
            EXPECT_EQ(edge.face_b, LA_NO_FACE);
        } else {
            EXPECT_EQ(edge.face_b & LA_FACE_INDEX, of_edge[1].first);
            EXPECT_EQ((edge.face_b & LA_FACE_FLIPPED) != 0, of_edge[0].second == of_edge[1].second);
        }
    }
}

TEST(MeshEdges, EveryEdgeOfARandomSoupStandsOnce) {
    test::Random random{11};
    for (int round = 0; round < 60; ++round) {
        expect_every_edge_once(test::random_soup(random, 4 + random.below(30), random.below(90)));
    }
}

TEST(MeshEdges, EveryEdgeOfAManifoldStandsOnce) {
    test::Random random{12};
    expect_every_edge_once(test::sphere(3));
    expect_every_edge_once(test::with_random_windings(test::sphere(2), random));
    expect_every_edge_once(test::height_field(random, 10, 1));
    expect_every_edge_once(test::moebius_band(9));
    expect_every_edge_once(test::cylinder(300, true)); // fans of 300 edges at one vertex
}

TEST(MeshEdges, AClosedMeshHasTheEdgesEulerAsksFor) {
    for (int level = 0; level < 4; ++level) {
        const WeldedMesh welded = weld(test::sphere(level));
        const std::vector<MeshEdge> edges = mesh_edges(welded);
        EXPECT_EQ(edges.size(), welded.vertices.size() + welded.triangles.size() - 2);
        for (const MeshEdge& edge : edges) {
            EXPECT_EQ(edge.face_count, 2U);
            EXPECT_EQ(edge.face_b & LA_FACE_FLIPPED, 0U);
        }
    }
}

TEST(MeshEdges, AHalfTwistHasOneDisagreement) {
    const std::vector<MeshEdge> edges = mesh_edges(weld(test::moebius_band(12)));
    EXPECT_EQ(std::ranges::count_if(edges,
                                    [](const MeshEdge& edge) {
                                        return edge.face_count == 2 &&
                                               (edge.face_b & LA_FACE_FLIPPED) != 0;
                                    }),
              1);
}

TEST(Classify, ACubeHasTwelveCreases) {
    const Kinds kinds = kinds_of(test::cube());
    EXPECT_EQ(count(kinds, LineKind::crease), 12);
    EXPECT_EQ(count(kinds, std::nullopt), 6); // the diagonals are flat and never a silhouette
}

TEST(Classify, ACreaseIsBentByMoreThanTheThreshold) {
    for (const bool flipped : {false, true}) {
        for (float degrees = 1; degrees < 180; ++degrees) {
            const float angle = glm::radians(degrees);
            const Mesh mesh = test::bent_pair(angle, flipped);
            const VertexPair common{0, 1};
            EXPECT_EQ(kinds_of(mesh, with_crease_angle(angle - 1e-5F))[common], LineKind::crease)
                << degrees << (flipped ? " flipped" : "");
            EXPECT_EQ(kinds_of(mesh, with_crease_angle(angle + 1e-5F))[common],
                      LineKind::silhouette)
                << degrees << (flipped ? " flipped" : "");
        }
    }
}

TEST(Classify, TheSharpestFoldIsACreaseAndAFlatPairIsNothing) {
    for (const bool flipped : {false, true}) {
        Mesh mesh = test::bent_pair(0, flipped);
        EXPECT_EQ((kinds_of(mesh)[{0, 1}]), std::nullopt);
        mesh.positions[3] = {-2, 0.5F, 0}; // lies over the first triangle
        EXPECT_EQ((kinds_of(mesh)[{0, 1}]), LineKind::crease);
    }
}

TEST(Classify, TheBordersOfAnOpenStripAreBoundaries) {
    const Kinds kinds = kinds_of(test::open_strip(5));
    EXPECT_EQ(count(kinds, LineKind::boundary), 12);
    EXPECT_EQ(count(kinds, std::nullopt), 9);
}

TEST(Classify, EdgesOfManyFacesAreKept) {
    for (const std::uint32_t faces : {3U, 4U, 7U}) {
        Kinds kinds = kinds_of(test::faces_on_an_edge(faces));
        EXPECT_EQ((kinds[{0, 1}]), LineKind::boundary) << faces;
        EXPECT_EQ(count(kinds, LineKind::boundary), 1 + 2 * static_cast<int>(faces));
    }
}

TEST(Classify, ATwoSidedQuadHasFourBoundariesOnly) {
    const Kinds kinds = kinds_of(test::with_own_corners(test::two_sided_quad()));
    EXPECT_EQ(kinds.size(), 5U);
    EXPECT_EQ(count(kinds, LineKind::boundary), 4);
}

TEST(Classify, BordersBetweenGroupsAreMaterialLines) {
    Mesh mesh = test::open_strip(2);
    mesh.groups.resize(2);
    mesh.triangle_group = {0, 0, 1, 1};
    Kinds kinds = kinds_of(mesh);
    EXPECT_EQ(count(kinds, LineKind::material), 1);
    EXPECT_EQ(count(kinds, LineKind::boundary), 6);

    mesh = test::bent_pair(1.5F, false); // a crease with any faces beside it
    mesh.groups.resize(2);
    mesh.triangle_group = {0, 1};
    EXPECT_EQ((kinds_of(mesh)[{0, 1}]), LineKind::crease);
}

TEST(Classify, AKindThatIsNotWantedGivesWayToTheNext) {
    Mesh mesh = test::bent_pair(1.5F, false);
    mesh.groups.resize(2);
    mesh.triangle_group = {0, 1};
    LineOptions options;
    const auto kind = [&] { return kinds_of(mesh, options)[{0, 1}]; };
    options.lines &= ~mask_of(LineKind::crease);
    EXPECT_EQ(kind(), LineKind::material);
    options.lines &= ~mask_of(LineKind::material);
    EXPECT_EQ(kind(), LineKind::silhouette);
    options.lines &= ~mask_of(LineKind::silhouette);
    EXPECT_EQ(kind(), std::nullopt);
    options.lines = mask_of(LineKind::crease);
    EXPECT_EQ(count(kinds_of(test::faces_on_an_edge(3), options), std::nullopt), 7);
}

TEST(Classify, WindingsDoNotChangeTheKinds) {
    test::Random random{13};
    for (int round = 0; round < 10; ++round) {
        const Mesh field = test::with_random_groups(test::height_field(random, 8, 1.5F), random, 2);
        EXPECT_TRUE(placed_kinds_of(test::with_random_windings(field, random)) ==
                    placed_kinds_of(field));
    }
}

TEST(Classify, ScaleDoesNotChangeTheKinds) {
    test::Random random{14};
    const Mesh field = test::height_field(random, 10, 1);
    const Kinds expected = kinds_of(field);
    for (const float scale : {0x1p-60F, 0x1p-20F, 0x1p20F, 0x1p60F}) { // exact
        const Mesh scaled = test::moved(field, glm::scale(glm::mat4{1}, glm::vec3{scale}));
        EXPECT_TRUE(kinds_of(scaled) == expected) << scale;
    }
}

TEST(Classify, TheOrderOfTrianglesDoesNotChangeTheKinds) {
    test::Random random{15};
    const Mesh field = test::with_random_groups(test::height_field(random, 8, 1), random, 3);
    Mesh shuffled = test::with_own_corners(field);
    for (std::size_t i = shuffled.triangles.size() - 1; i > 0; --i) {
        const std::uint32_t j = random.below(static_cast<std::uint32_t>(i + 1));
        std::swap(shuffled.triangles[i], shuffled.triangles[j]);
        std::swap(shuffled.triangle_group[i], shuffled.triangle_group[j]);
    }
    EXPECT_TRUE(placed_kinds_of(shuffled) == placed_kinds_of(field));
}

/// The kinds of the three edges of the sliver that closes a T-junction.
struct JunctionKinds {
    std::optional<LineKind> whole, lower, upper;

    explicit JunctionKinds(const Mesh& mesh) {
        const auto kinds = placed_kinds_of(mesh);
        const auto between = [&](int i, int j) {
            const glm::vec3 a = mesh.positions[i];
            const glm::vec3 b = mesh.positions[j];
            return kinds.at({a.x, a.y, a.z, b.x, b.y, b.z});
        };
        whole = between(0, 1);
        lower = between(0, 2);
        upper = between(1, 2);
    }
    bool any(LineKind kind) const { return whole == kind || lower == kind || upper == kind; }
    /// True if the whole line from one end to the other is of this kind.
    bool covered(LineKind kind) const { return whole == kind || (lower == kind && upper == kind); }
};

TEST(Slivers, NeitherMakeNorHideACrease) {
    for (float degrees = -179; degrees < 180; degrees += 2) {
        const JunctionKinds kinds{test::split_edge(glm::radians(degrees))};
        if (std::abs(degrees) > 28) { // the limit is 28.8
            EXPECT_TRUE(kinds.covered(LineKind::crease)) << degrees << " degrees";
        } else {
            EXPECT_FALSE(kinds.any(LineKind::crease)) << degrees << " degrees";
            EXPECT_TRUE(kinds.covered(LineKind::silhouette)) << degrees << " degrees";
        }
    }
    const JunctionKinds flat{test::split_edge(0)};
    EXPECT_FALSE(flat.any(LineKind::crease) || flat.any(LineKind::silhouette));
}

TEST(Slivers, WindingsDoNotMatter) {
    test::Random random{16};
    for (int round = 0; round < 50; ++round) {
        const Mesh sharp = test::with_random_windings(test::split_edge(1), random);
        EXPECT_TRUE(placed_kinds_of(sharp) == placed_kinds_of(test::split_edge(1)));
        EXPECT_FALSE(JunctionKinds{test::with_random_windings(test::split_edge(0), random)}.any(
            LineKind::crease));
    }
}

/// Coordinates of files are rounded, so the split vertex lies beside the edge by some units in the
/// last place. Far from the origin these are larger.
TEST(Slivers, NeitherMakeNorHideACreaseWhereCoordinatesAreRounded) {
    test::Random random{17};
    for (const float reach : {0.0F, 1.0F, 10.0F, 100.0F}) {
        int made = 0;
        int hidden = 0;
        constexpr int rounds = 200;
        for (int round = 0; round < rounds; ++round) {
            const glm::mat4 placement = random.placement(reach);
            const JunctionKinds flat{test::moved(test::split_edge(0), placement)};
            made += flat.any(LineKind::crease) ? 1 : 0;
            const JunctionKinds bent{test::moved(test::split_edge(1), placement)};
            hidden += bent.covered(LineKind::crease) ? 0 : 1;
        }
        EXPECT_EQ(made, 0) << "of " << rounds << " within " << reach << " of the origin";
        EXPECT_EQ(hidden, 0) << "of " << rounds << " within " << reach << " of the origin";
    }
}

/// Slivers on a line from vertex 0 to vertex 2. The middle one has only slivers beside it. On one
/// side the line is split at vertex 3, on the other at 1, 4 and 5. The line is a crease between the
/// sides.
TEST(Slivers, ThatTouchSliversOnlyHideNoCrease) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 2, 0}, {0, 4, 0},  {0, 2.5F, 0},
                      {0, 1, 0}, {0, 3, 0}, {-1, 2, 0}, {0, 2, 1}};
    mesh.triangles = {{0, 3, 6}, {3, 2, 6}, {4, 0, 7}, {1, 4, 7}, {5, 1, 7},
                      {2, 5, 7}, {3, 0, 4}, {4, 1, 5}, {2, 3, 5}, {3, 4, 5}};
    const WeldedMesh welded = weld(mesh);
    std::vector<MeshEdge> edges = mesh_edges(welded);
    const std::vector<glm::dvec3> normals = face_normals(welded);
    replace_slivers(welded, normals, edges);
    const std::vector<double> bends = bends_of(edges, normals);
    float hidden = 0;
    for (float y = 0.05F; y < 4; y += 0.1F) {
        bool covered = false;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const glm::vec3 p = welded.vertices[edges[i].p];
            const glm::vec3 q = welded.vertices[edges[i].q];
            const bool here =
                p.x == 0 && p.z == 0 && q.x == 0 && q.z == 0 && (p.y < y) != (q.y < y);
            covered =
                covered || (here && classify(edges[i], welded, bends[i], {}) == LineKind::crease);
        }
        hidden += covered ? 0 : 0.1F;
    }
    EXPECT_EQ(hidden, 0) << "of a crease 4 long";
}

} // namespace
} // namespace lineatlas
