#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "edges.hpp"
#include "known_edges.hpp"
#include "lineatlas/surface.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Edges at which two surfaces of the file continue each other smoothly, such as where a fillet
/// ends. Edges that cut one surface in two are left out. `shapes`: plain_shape() of each shape of
/// `surfaces`.
std::vector<std::uint32_t> tangent_edges(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                                         const KnownEdges& known, const KnownSurfaces& surfaces,
                                         std::span<const SurfaceShape> shapes);

} // namespace lineatlas
