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

/// The lines of a surface's shape.
struct FoundRidges {
    std::vector<Ridge> ridges;
    std::vector<bool> said; ///< edges: of those that may go, which a ridge or valley runs along
};

/// The ridges and valleys of these faces (docs/lines.md has the rules). None runs beside an edge
/// that is `drawn`; where one runs along an edge that `may_go`, that says the same.
FoundRidges find_ridges(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                        std::span<const std::uint32_t> faces, const std::vector<bool>& drawn,
                        const std::vector<bool>& may_go);

} // namespace lineatlas
