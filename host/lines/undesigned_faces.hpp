#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "edges.hpp"
#include "parts.hpp"
#include "weld.hpp"

namespace lineatlas {

/// The triangles of undesigned parts: scanned, sculpted or grown surfaces. In designed parts most
/// triangles have a neighbour in their own plane, or are slivers.
std::vector<std::uint32_t> undesigned_faces(const WeldedMesh& mesh,
                                            const std::vector<MeshEdge>& edges,
                                            std::span<const double> bends, const MeshParts& parts);

} // namespace lineatlas
