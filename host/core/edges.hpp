#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lineatlas/lines.hpp"
#include "weld.hpp"

namespace lineatlas {

/// An undirected mesh edge with the first two triangles that use it.
struct MeshEdge {
    std::uint32_t p, q;           ///< vertices, in the winding of `face_a`
    std::uint32_t face_a, face_b; ///< LA_NO_FACE where there is none; `face_b` may be LA_FACE_FLIPPED
    std::uint32_t face_count;     ///< triangles that use the edge: 1 boundary, above 2 non-manifold
};

/// Every edge of the mesh once, ordered by its smaller vertex. Any number of triangles may share an
/// edge, in any winding, which a halfedge structure cannot hold (docs/decisions.md).
std::vector<MeshEdge> mesh_edges(const WeldedMesh& mesh);

/// Unit normals per triangle in double precision. A triangle without area takes the normal of the
/// neighbour across its longest edge, so that a sliver neither makes nor hides a crease.
std::vector<glm::dvec3> face_normals(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges);

/// The kind of line that the edge is under `options`; nothing if it is never one.
std::optional<LineKind> classify(const MeshEdge& edge, const WeldedMesh& mesh,
                                 const std::vector<glm::dvec3>& normals, const LineOptions& options);

} // namespace lineatlas
