#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace lineatlas {

struct RingPoint {
    glm::dvec2 at;
    std::uint32_t position;
};
using Ring = std::vector<RingPoint>;

/// One ring around what lies between an outline (counter-clockwise) and the holes in it
/// (clockwise): each hole is joined by a bridge that is walked both ways.
Ring bridged(Ring outline, std::vector<Ring> holes);

} // namespace lineatlas
