#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "edges.hpp"
#include "lineatlas/lines.hpp"
#include "weld.hpp"

namespace lineatlas {

/// The inputs of find_contours().
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

} // namespace lineatlas
