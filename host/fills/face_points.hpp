#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "planar_map.hpp"

namespace lineatlas {

/// A point within a face.
struct FacePoint {
    std::uint32_t face;
    glm::dvec2 at; ///< in units of the grid
    double room;   ///< length of the part that it stands for of a horizontal line
};

/// Points of each face of a map, except of the face around all others: on five horizontal lines and
/// beside the face's borders, in the order of the faces. If `closely` says so of a face, the lines
/// are a few pixels apart. `pixel`: in units of the grid.
std::vector<FacePoint> face_points(const PlanarMap& map, double pixel,
                                   const std::vector<bool>& closely);

} // namespace lineatlas
