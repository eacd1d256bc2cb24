#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// A corner is 3 times the number of a triangle and 0 to 2. The one after it in its triangle.
constexpr std::uint32_t next_corner(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// Of a triangle with these sides at a corner, as long as their angle; `known`: in its place, if it
/// is not zero.
glm::dvec3 normal_by_angle(glm::dvec3 u, glm::dvec3 v, glm::dvec3 known);

/// What has a corner of contours in common: places in LineSet::triangles, each 3 times the number
/// of a triangle and 0 to 2. Of corner i those from offsets[i] up to offsets[i + 1].
struct CornerPlaces {
    std::vector<std::uint32_t> offsets, places;
};
CornerPlaces find_corner_places(const Contours& contours, std::span<const Segment> segments);

/// Normals of contours anew, from the triangles as they stand: those about a corner, by the angles
/// that they have there.
void find_normals(LineSet& lines);

} // namespace lineatlas
