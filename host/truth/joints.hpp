#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "drawn_lines.hpp"

namespace lineatlas {

/// Two ends of lines that nearly meet.
struct Gap {
    glm::vec2 at; ///< one of the ends, pixels from the upper left corner of the picture, y down
    float width;  ///< from there to the other, pixels
};

/// Pairs of ends of different paths less than a pixel apart, but farther than 0.02, as coordinates
/// of a file are rounded, each the nearest to the other; widest first. An end that lies on another
/// path meets that one, and counts for no gap.
std::vector<Gap> gaps_of(const DrawnLines& drawn, glm::ivec2 picture);

} // namespace lineatlas
