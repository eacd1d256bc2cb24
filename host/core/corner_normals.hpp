#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The next corner of the same triangle. The number of a corner is 3 times that of its triangle,
/// plus 0 to 2.
constexpr std::uint32_t next_corner(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// The normal of a triangle with sides u and v at a corner; its length is the angle between them. A
/// `known` normal that is not zero replaces its direction.
glm::dvec3 normal_by_angle(glm::dvec3 u, glm::dvec3 v, glm::dvec3 known);

/// The corners of triangles that each corner of contours stands for, numbered as in next_corner().
/// Those of corner i go from offsets[i] up to offsets[i + 1].
struct CornerPlaces {
    std::vector<std::uint32_t> offsets, places;
};
CornerPlaces find_corner_places(const Contours& contours, std::span<const Segment> segments);

/// Finds the normals of contours again from the present triangles. At a corner the normals of its
/// triangles are weighted by their angles.
void find_normals(LineSet& lines);

} // namespace lineatlas
