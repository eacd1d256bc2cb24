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
    std::vector<bool> said; ///< edges that may go and that a ridge or valley runs along
};

/// Finds the ridges and valleys of these faces (docs/lines.md has the rules). None runs beside an
/// edge that is `drawn`. An edge that `may_go` and that one runs along is reported in `said`.
FoundRidges find_ridges(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                        std::span<const std::uint32_t> faces, const std::vector<bool>& drawn,
                        const std::vector<bool>& may_go);

} // namespace lineatlas
