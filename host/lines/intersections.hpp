#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lineatlas/lines.hpp"
#include "triangle_tree.hpp"
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

/// All of one object, in no order that means anything; but none of faces that only touch, or lie in
/// one plane. `tree` is of the object's triangles; parts, its owners, don't meet themselves.
/// `diagonal` is the model's.
std::vector<Intersection> find_intersections(const WeldedMesh& mesh,
                                             const std::vector<glm::dvec3>& normals,
                                             const TriangleTree& tree, double diagonal);

/// A line that is drawn anyway.
struct DrawnLine {
    std::uint32_t p, q; ///< vertices
};

/// Takes out those beside which a line of the same object runs that is seen wherever they are: it
/// would be drawn twice. What runs behind the surface of one of the two faces doesn't count.
void drop_doubled(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals,
                  std::span<const DrawnLine> lines, double diagonal,
                  std::vector<Intersection>& intersections);

} // namespace lineatlas
