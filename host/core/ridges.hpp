#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "edges.hpp"
#include "intersections.hpp"
#include "lineatlas/lines.hpp"
#include "weld.hpp"

namespace lineatlas {

/// A crest or a furrow of a surface, from edge to edge of its triangles.
struct Ridge {
    LineKind kind;                    ///< ridge or valley
    std::vector<EdgePlace> points;    ///< of a closed one the first stands last once more
    std::vector<std::uint32_t> faces; ///< between each two points the triangle that it runs through
};

/// The ridges and valleys of these faces (docs/lines.md has the rules). None runs along an edge
/// that `drawn` says to be a line.
std::vector<Ridge> find_ridges(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                               std::span<const std::uint32_t> faces,
                               const std::vector<bool>& drawn);

} // namespace lineatlas
