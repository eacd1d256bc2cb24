#pragma once

#include <cstdint>
#include <vector>

#include "edges.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Connected parts: triangles that share vertices.
struct MeshParts {
    std::vector<std::uint32_t> of_vertex; ///< parts are numbered from 0 in order of appearance
    std::uint32_t count = 0;
};

MeshParts find_parts(const WeldedMesh& mesh);

/// Six times the volume that each part encloses. It is below 0 if the triangles look inwards, and 0
/// for a part that is not closed. A part is closed if all of its edges have two triangles, which
/// run along the edge in opposite directions.
std::vector<double> enclosed_volumes(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                                     const MeshParts& parts);

/// Whether each part is a solid: a closed part whose triangles look outwards, so that its volume is
/// above 0.
std::vector<bool> solid_parts(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                              const MeshParts& parts);

/// Turns the triangles of closed parts that look inwards, and their edges, which run in the winding
/// of the triangles. Does the same with bodies that abut, as walls do, if all of them look inwards.
void turn_outwards(WeldedMesh& mesh, std::vector<MeshEdge>& edges, const MeshParts& parts);

} // namespace lineatlas
