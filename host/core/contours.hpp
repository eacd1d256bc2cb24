#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "edges.hpp"
#include "lineatlas/lines.hpp"
#include "weld.hpp"

namespace lineatlas {

/// What find_contours() looks at.
struct ContourInput {
    const WeldedMesh& mesh;
    std::span<const MeshEdge> edges;
    std::span<const double> bends;                  ///< of edges
    std::span<const std::optional<LineKind>> kinds; ///< of edges
    double most_bend;                               ///< of edges within a patch, radians
    std::span<const glm::vec3> corner_normals;      ///< Mesh::corner_normals
    std::span<const std::uint32_t> undesigned;      ///< triangles: see undesigned_faces()
};

/// Where silhouettes are smooth.
struct FoundContours {
    Contours contours;                ///< without `replaced`
    std::vector<std::uint32_t> faces; ///< triangle of each of its faces
    /// Per edge: whether it is a candidate no more; empty if no silhouette is smooth.
    std::vector<bool> replaces;
};

/// Finds the smooth patches of a mesh: triangles that hang together across edges which may be
/// silhouettes and are nothing else. Of Silhouettes::smooth one is smooth if it bends at all; of
/// Silhouettes::automatic if besides nobody designed it, or, where any normals of the surface are
/// known, if all of its are.
FoundContours find_contours(const ContourInput& input, Silhouettes rule);

/// What has a corner of contours in common: places in LineSet::triangles, each 3 times the number
/// of a triangle and 0 to 2. Of corner i those from offsets[i] up to offsets[i + 1].
struct CornerPlaces {
    std::vector<std::uint32_t> offsets, places;
};
CornerPlaces find_corner_places(const Contours& contours, std::span<const Segment> segments);

/// Normals of contours anew, from the triangles as they stand: those about a corner, by the angles
/// that they have there.
void find_normals(LineSet& lines);

} // namespace lineatlas
