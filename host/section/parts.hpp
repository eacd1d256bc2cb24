#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// The pieces of a mesh that are connected by edges, and the object of each.
struct Parts {
    std::vector<std::uint32_t> of_triangle; ///< its piece
    std::vector<std::uint32_t> look;        ///< per piece: those of one look are hatched alike
    std::vector<std::string> name;          ///< per piece: its object's; empty where none has one
};

/// `places`: per position a number of its place (place_numbers).
Parts find_parts(const Mesh& mesh, const std::vector<std::uint32_t>& places);

/// Positions at one place (see PlaceGrid) have one number, that of the first of them; so have those
/// that are joined by others between them.
std::vector<std::uint32_t> place_numbers(const std::vector<glm::vec3>& positions, double rounding);

} // namespace lineatlas
