#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// The pieces of a mesh that are connected by edges, and the object of each.
struct Parts {
    std::vector<std::uint32_t> of_triangle; ///< the piece of each triangle
    std::vector<std::uint32_t> look;        ///< per piece; pieces of one look are hatched alike
    std::vector<std::string> name;          ///< per piece the name of its object; empty if no
                                            ///< object has a name
};

/// Finds the pieces of a mesh. `places`: per position the number of its place (place_numbers).
Parts find_parts(const Mesh& mesh, const std::vector<std::uint32_t>& places);

/// The number of each position's place: the index of the first position there. Positions are at one
/// place if they are near each other (see PlaceGrid), or connected by other positions that are.
std::vector<std::uint32_t> place_numbers(const std::vector<glm::vec3>& positions, double rounding);

} // namespace lineatlas
