#pragma once

#include <cstdint>
#include <vector>

#include "edges.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Connected parts: triangles that share vertices.
struct MeshParts {
    std::vector<std::uint32_t> of_vertex; ///< numbered from 0 as they come
    std::uint32_t count = 0;
};

MeshParts find_parts(const WeldedMesh& mesh);

/// What parts enclose, six times; below 0 where their triangles look inwards, and 0 of such that
/// are not closed: not all edges are of two triangles, which run along it in opposite directions.
std::vector<double> enclosed_volumes(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                                     const MeshParts& parts);

/// Which parts are solids: all edges are of two triangles, which run along it in opposite
/// directions, and those look outwards, for what they enclose is above 0.
std::vector<bool> solid_parts(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                              const MeshParts& parts);

/// Turns the triangles of parts that would be solids but for looking inwards, and their edges,
/// which run in their winding. So it does with bodies that abut, as walls do, if all of them look
/// inwards.
void turn_outwards(WeldedMesh& mesh, std::vector<MeshEdge>& edges, const MeshParts& parts);

} // namespace lineatlas
