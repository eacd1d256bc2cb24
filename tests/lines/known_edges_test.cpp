// Edges whose kinds come from the file, not from their angles.
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {
namespace {

using Kind = KnownEdge::Kind;

/// Two triangles that meet at a right angle along 0-1.
Mesh roof() {
    return {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
            .triangles = {{0, 1, 2}, {1, 0, 3}},
            .triangle_group = {},
            .groups = {},
            .polylines = {}};
}

std::array<std::uint32_t, LA_KIND_COUNT> counts(const Mesh& mesh, const LineOptions& options = {}) {
    return extract_lines(mesh, options).kind_counts;
}

TEST(KnownEdges, SayWhatAnglesDoNot) {
    Mesh mesh = roof();
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], 1U);
    mesh.known_edges = {{0, 1, Kind::smooth}, {1, 2, Kind::free}};
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], 0U);
    EXPECT_EQ(counts(mesh)[LA_KIND_SILHOUETTE], 1U);
    EXPECT_EQ(counts(mesh)[LA_KIND_BOUNDARY], 1U); // the file does not know the others
    EXPECT_EQ(counts(mesh, {.smooth_edges = true})[LA_KIND_CREASE], 1U);
    mesh.known_edges[0].kind = Kind::seam;
    EXPECT_EQ(counts(mesh, {.smooth_edges = true})[LA_KIND_CREASE], 0U);
}

TEST(KnownEdges, SharpOnesAreCreasesHoweverFlat) {
    Mesh mesh = roof();
    mesh.positions[3] = {0.1F, -1, 0.01F};
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], 0U);
    mesh.known_edges = {{1, 0, Kind::sharp}};
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], 1U);
    EXPECT_EQ(counts(mesh, {.lines = mask_of(LineKind::silhouette)})[LA_KIND_SILHOUETTE], 1U);
}

/// A plane square as a fan of four triangles. The third corner of one triangle is lifted by 45
/// degrees.
Mesh fan(float height) {
    return {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, height}},
            .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}},
            .triangle_group = {},
            .groups = {},
            .polylines = {}};
}

TEST(KnownEdges, MarkedOnesAreCreasesAndLeaveOthersToAngles) {
    Mesh mesh = fan(0);
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], 0U);
    mesh.known_edges = {{2, 0, Kind::marked}};
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], 1U);
    EXPECT_EQ(counts(mesh)[LA_KIND_BOUNDARY], 4U);
    mesh = fan(2);
    const std::uint32_t bent = counts(mesh)[LA_KIND_CREASE];
    EXPECT_GE(bent, 2U);
    mesh.known_edges = {{2, 0, Kind::marked}};
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], bent + 1);
    EXPECT_EQ(counts(mesh, {.crease = 0.5F})[LA_KIND_CREASE], bent + 1);
    mesh.known_edges.push_back({0, 1, Kind::seam}); // now the file names all edges
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], 1U);
}

TEST(KnownEdges, SmoothOnesAreTangentBesides) {
    Mesh mesh = roof();
    mesh.known_edges = {{0, 1, Kind::smooth}};
    EXPECT_EQ(counts(mesh)[LA_KIND_TANGENT], 1U);
    EXPECT_EQ(counts(mesh)[LA_KIND_SILHOUETTE], 1U);
    EXPECT_EQ(counts(mesh, {.lines = usual_line_kinds})[LA_KIND_TANGENT], 0U);
    EXPECT_EQ(counts(mesh, {.smooth_edges = true})[LA_KIND_TANGENT], 0U) << "a crease already";
    mesh.known_edges[0].kind = Kind::sharp;
    EXPECT_EQ(counts(mesh)[LA_KIND_TANGENT], 0U);
}

TEST(KnownEdges, BetweenGroupsSmoothOnesAreMaterialLines) {
    Mesh mesh = roof();
    mesh.triangle_group = {0, 1};
    mesh.groups.resize(2);
    mesh.known_edges = {{0, 1, Kind::sharp}};
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], 1U);
    EXPECT_EQ(counts(mesh)[LA_KIND_MATERIAL], 0U);
    mesh.known_edges[0].kind = Kind::smooth;
    EXPECT_EQ(counts(mesh)[LA_KIND_MATERIAL], 1U);
}

TEST(KnownEdges, AreFoundBetweenWeldedPositions) {
    Mesh mesh = roof();
    // The second triangle has separate corners.
    mesh.positions.insert(mesh.positions.end(), {{0, 0, 0}, {1, 0, 0}});
    mesh.triangles[1] = {5, 4, 3};
    mesh.known_edges = {{4, 5, Kind::smooth}};
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], 0U);
    mesh.known_edges.push_back({0, 1, Kind::sharp}); // one of the edge's two parts is sharp
    EXPECT_EQ(counts(mesh)[LA_KIND_CREASE], 1U);
}

TEST(KnownEdges, WithIndicesBeyondThePositionsAreRefused) {
    Mesh mesh = roof();
    mesh.known_edges = {{0, 4, Kind::sharp}};
    EXPECT_THROW(extract_lines(mesh), UsageError);
}

} // namespace
} // namespace lineatlas
