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

/// Edges of faces that go on: no line is seen there from anywhere.
struct Seams {
    std::vector<bool> of_edge;      ///< seams all along
    std::vector<EdgePart> left;     ///< what is a line of the edges that are seams in part
    std::vector<std::uint32_t> cut; ///< those edges, ascending
};

/// What is one surface where triangles meet in a plane.
struct SeamSurfaces {
    std::span<const std::uint32_t> material; ///< per triangle, for boundaries
    /// Per triangle, for creases: what has no material is of its part, since bodies of an assembly
    /// that end in one plane are drawn each.
    std::span<const std::uint32_t> body;
    /// Per triangle the owner in the tree whose triangles need not be looked at: its own part, if
    /// that is closed; else BoxTree::nobody.
    std::span<const std::uint32_t> closed_part;
};

/// Which boundaries and creases (`kinds`) are seams. A boundary is one where, just beyond it, a
/// face of the same material goes on in the same plane; a crease where one of its faces goes on,
/// and the other goes on too or has another face over it. `trees` are of the objects,
/// each of which has seams within itself alone.
Seams find_seams(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                 const std::vector<glm::dvec3>& normals,
                 std::span<const std::optional<LineKind>> kinds, const TriangleTrees& trees,
                 const SeamSurfaces& surfaces);

} // namespace lineatlas
