#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "edges.hpp"
#include "lineatlas/lines.hpp"
#include "triangle_tree.hpp"
#include "weld.hpp"

namespace lineatlas {

/// A part of an edge, as shares of the way from its vertex p to its vertex q.
struct EdgePart {
    std::uint32_t edge;
    double from, to;
};

/// Edges across which a face goes on. No line is visible there from anywhere.
struct Seams {
    std::vector<bool> of_edge;      ///< seams all along
    std::vector<EdgePart> left;     ///< the parts that are lines, of edges that are seams in part
    std::vector<std::uint32_t> cut; ///< those edges, ascending
};

/// Which triangles that meet in a plane are one surface.
struct SeamSurfaces {
    std::span<const std::uint32_t> material; ///< per triangle, for boundaries
    std::span<const std::uint32_t> body;     ///< per triangle, for creases: bodies_of()
    /// Per triangle the owner in the tree whose triangles need no look: its own part if that is
    /// closed, else BoxTree::nobody.
    std::span<const std::uint32_t> closed_part;
};

/// Finds the boundaries and creases (`kinds`) that are seams. A boundary is a seam where, just
/// beyond it, a face of the same material goes on in the same plane. A crease is a seam where one
/// of its faces goes on, and the other goes on too or has another face over it. `trees`: one per
/// object, because seams are within objects. `left_out`: edges that are not looked at; may be
/// empty.
Seams find_seams(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                 const std::vector<glm::dvec3>& normals,
                 std::span<const std::optional<LineKind>> kinds, const TriangleTrees& trees,
                 const SeamSurfaces& surfaces, const std::vector<bool>& left_out = {});

} // namespace lineatlas
