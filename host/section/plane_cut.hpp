#pragma once

#include <cstdint>
#include <vector>

#include "lineatlas/mesh.hpp"
#include "plane_frame.hpp"

namespace lineatlas {

/// A step of the outline of a cut, where a plane goes through one triangle.
struct CutStep {
    std::uint32_t from, to; ///< positions, one for each place; the solid lies to the left, seen
                            ///< against the normal
    std::uint32_t part;     ///< the part of the triangle
    std::uint32_t triangle; ///< in the mesh that is left
    bool two_sided = false; ///< the triangle stands there the other way round, too
};

/// Lines of no part are cut.
inline constexpr std::uint32_t no_part = 0xFFFFFFFF;

/// The parts that a mesh consists of.
struct PartNumbers {
    std::vector<std::uint32_t> of_triangle;
    std::vector<std::uint32_t> of_polyline; ///< or no_part
};

/// The part of a mesh that one plane leaves, open along the cut.
struct PlaneCut {
    Mesh mesh;
    PartNumbers parts;
    std::vector<CutStep> steps;
    bool misses = false;    ///< all of the mesh lies on one side
    bool cuts_none = false; ///< all parts that are not left whole lie on one side
};

/// Takes away the part of a mesh on the side that the plane's normal points to. Corners nearer to
/// the plane than `rounding` lie on it and count as beyond. Corners nearer to each other than
/// `rounding` are at one place, and all triangles use one position of it. So the cut of a closed
/// mesh is closed: each edge is either cut for both of its triangles or for neither. Triangles that
/// stand twice are cut once. `uncut`: per part whether it stays whole.
PlaneCut cut_by_plane(const Mesh& mesh, const PartNumbers& parts, const PlaneFrame& plane,
                      double rounding, const std::vector<bool>& uncut);

} // namespace lineatlas
