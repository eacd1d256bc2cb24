#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "box_tree.hpp"
#include "lineatlas/lines.hpp"
#include "weld.hpp"

namespace lineatlas {

/// A place within an edge of a triangle: a share of the way from one vertex to another.
struct EdgePlace {
    std::uint32_t from, to; ///< from < to
    double share;
    bool operator==(const EdgePlace&) const = default;
};

/// Where two triangles pass through each other: a line that both hold.
struct Intersection {
    EdgePlace p, q;
    std::uint32_t face_a, face_b; ///< face_a < face_b
};

/// All of them, in no order that means anything; but none of faces that only touch, or lie in one
/// plane. `tree` is of the mesh's triangles, its owners the parts that don't meet themselves. With
/// `object`, of triangles, only those of one object meet.
std::vector<Intersection> find_intersections(const WeldedMesh& mesh,
                                             const std::vector<glm::dvec3>& normals,
                                             const BoxTree& tree,
                                             std::span<const std::uint32_t> object);

/// A line that is drawn anyway.
struct DrawnLine {
    std::uint32_t p, q; ///< vertices
};

/// Takes out those beside which a line runs that is seen wherever they are: it would be drawn
/// twice. What runs behind the surface of one of the two faces doesn't count.
void drop_doubled(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals,
                  std::span<const DrawnLine> lines, std::vector<Intersection>& intersections);

} // namespace lineatlas
