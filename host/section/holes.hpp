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

/// One ring around the area between an outline (counter-clockwise) and its holes (clockwise). A
/// bridge joins each hole to the ring, which runs along the bridge in both directions.
Ring bridged(Ring outline, std::vector<Ring> holes);

} // namespace lineatlas
