#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "box_tree.hpp"
#include "edges.hpp"
#include "lineatlas/lines.hpp"
#include "weld.hpp"

namespace lineatlas {

/// A part of an edge, as shares of the way from its p to its q.
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

/// Which boundaries and creases (`kinds`) are seams. A boundary is one where, just beyond it, a
/// face of the same material goes on in the same plane; a crease where one of its faces goes on,
/// and the other goes on too or has another face over it. `tree` is of the mesh's triangles; faces
/// of one `material` are of one.
Seams find_seams(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                 const std::vector<glm::dvec3>& normals,
                 std::span<const std::optional<LineKind>> kinds, const BoxTree& tree,
                 std::span<const std::uint32_t> material);

} // namespace lineatlas
