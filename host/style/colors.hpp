#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace lineatlas {

/// "#rrggbb", or one of the usual names; nothing for anything else.
std::optional<glm::vec3> parse_color(std::string_view text);

/// The nearest "#rrggbb" of a colour from 0 to 1.
std::string hex_color(glm::vec3 color);

} // namespace lineatlas
