#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planar_map.hpp"

namespace lineatlas {

/// The kind of a face that belongs to no area.
inline constexpr std::uint32_t no_area = 0xFFFFFFFF;

/// An area: faces of one kind.
struct Area {
    std::uint32_t kind;                        ///< as in the argument
    std::vector<std::vector<GridPlace>> rings; ///< with the area to the left, from x towards y
};

/// Joins the faces of a map that are of one kind. Faces with no_area are left out. Places where
/// borders are straight to within `tolerance` units of the grid are left out, the same ones on both
/// sides of a border. In ascending order of kinds.
std::vector<Area> join_faces(const PlanarMap& map, std::span<const std::uint32_t> kinds,
                             double tolerance);

} // namespace lineatlas
