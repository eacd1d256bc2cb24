#pragma once

#include <vector>

#include "lineatlas/mesh.hpp"
#include "plane_frame.hpp"

namespace lineatlas {

/// A step of the outline of a cut, where a plane goes through one triangle.
struct CutStep {
    std::uint32_t from, to; ///< positions, one for each place; what is solid lies to the left, seen
                            ///< against the normal
    std::uint32_t part;     ///< of the triangle
    std::uint32_t triangle; ///< of what is left
    bool two_sided = false; ///< the triangle stands there the other way round, too
};

/// What one plane leaves of a mesh, open where it cut.
struct PlaneCut {
    Mesh mesh;
    std::vector<std::uint32_t> part_of_triangle;
    std::vector<CutStep> steps;
    bool misses = false; ///< all of the mesh lies on one side
};

/// Takes away what lies on the side that the plane's normal points to. Corners nearer to the plane
/// than `rounding` lie on it, and count as beyond; those nearer to each other are at one place, and
/// triangles use one position of it. So the cut of what is closed is closed: each edge is either
/// cut for both of its triangles or for neither. What stands twice is cut once.
PlaneCut cut_by_plane(const Mesh& mesh, const std::vector<std::uint32_t>& part_of_triangle,
                      const PlaneFrame& plane, double rounding);

} // namespace lineatlas
