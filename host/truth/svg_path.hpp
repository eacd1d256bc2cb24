#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace lineatlas {

/// The lines of path data (SVG 1.1 §8.3): moves, lines, arcs (as chords of 6 degrees) and closings,
/// absolute or relative. Nothing if the data has anything else.
std::optional<std::vector<std::pair<glm::dvec2, glm::dvec2>>> parse_path(std::string_view data);

} // namespace lineatlas
