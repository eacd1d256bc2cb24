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

/// One ring around the area between an outline (counter-clockwise) and its holes (clockwise). Each
/// hole is joined to it by a bridge that the ring runs along in both directions.
Ring bridged(Ring outline, std::vector<Ring> holes);

} // namespace lineatlas
