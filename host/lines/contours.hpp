#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "edges.hpp"
#include "lineatlas/lines.hpp"
#include "parts.hpp"
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
    const MeshParts& parts;
    const std::vector<bool>& solid; ///< parts: see solid_parts()
};

/// Where silhouettes are smooth.
struct FoundContours {
    Contours contours;                ///< without `replaced`
    std::vector<std::uint32_t> faces; ///< triangle of each of its faces
    /// Per edge whether smooth silhouettes replace it as a candidate; empty if there are none.
    std::vector<bool> replaces;
};

/// Finds the smooth patches of a mesh. A patch has triangles that are connected across edges which
/// may be silhouettes and are no other lines. With Silhouettes::smooth a patch is smooth if it
/// bends at all. With Silhouettes::automatic a patch is smooth
/// - in a mesh with normals of surfaces, if it bends and all of its normals are known;
/// - else if nobody designed any of its triangles and it has at least 15,000 of them;
/// - else if it is of a solid, has at least 64 triangles, less than 30 % of them flat (an edge
///   bends by less than 0.5 degrees) and half of them no slivers (lowest altitude above a quarter
///   of the longest edge), if less than a tenth of its edges bend by more than 15 degrees, and if
///   it bends at one corner much as at the next.
FoundContours find_contours(const ContourInput& input, Silhouettes rule);

} // namespace lineatlas
