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
    std::vector<EdgePlace> points;    ///< for a closed line the first point is also the last
    std::vector<std::uint32_t> faces; ///< between each two points the triangle that it runs through
};

/// The lines of a surface's shape.
struct FoundRidges {
    std::vector<Ridge> ridges;
    std::vector<bool> said; ///< of the edges that may go, those that a ridge or valley runs along
};

/// Finds the ridges and valleys of these faces (docs/lines.md has the rules). They keep away from
/// edges that are `drawn`. Edges that `may_go`, since a ridge or valley repeats them, are `said`.
FoundRidges find_ridges(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                        std::span<const std::uint32_t> faces, const std::vector<bool>& drawn,
                        const std::vector<bool>& may_go);

} // namespace lineatlas
