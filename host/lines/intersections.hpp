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

/// All intersections within one object, in no particular order, except those of faces that only
/// touch or lie in one plane. `tree`: that of the object's triangles; its owners are parts, which
/// do not intersect themselves. `diagonal`: that of the model.
std::vector<Intersection> find_intersections(const WeldedMesh& mesh,
                                             const std::vector<glm::dvec3>& normals,
                                             const TriangleTree& tree, double diagonal);

/// A line that is drawn in any case.
struct DrawnLine {
    std::uint32_t p, q; ///< vertices
};

/// Drops intersections that would be drawn twice, because a line of the same object runs beside
/// them and is visible wherever they are. Lines behind the surface of one of the two faces do not
/// count.
void drop_doubled(const WeldedMesh& mesh, const std::vector<glm::dvec3>& normals,
                  std::span<const DrawnLine> lines, double diagonal,
                  std::vector<Intersection>& intersections);

} // namespace lineatlas
