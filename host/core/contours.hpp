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
};

/// Where silhouettes are smooth.
struct FoundContours {
    Contours contours;                ///< without `replaced`
    std::vector<std::uint32_t> faces; ///< triangle of each of its faces
    std::vector<bool> replaces;       ///< per edge: whether it is a candidate no more
};

/// Finds the smooth patches of a mesh: triangles that hang together across edges which may be
/// silhouettes and are nothing else. Of Silhouettes::automatic one is smooth if it has at least 64
/// triangles, less than 30 % of them flat (an edge bends by less than 0.5 degrees) and half of them
/// no slivers (lowest altitude above a quarter of the longest edge); where any normals of the
/// surface are known, if it bends and all of its are; of Silhouettes::smooth if it bends at all.
FoundContours find_contours(const ContourInput& input, Silhouettes rule);

} // namespace lineatlas
