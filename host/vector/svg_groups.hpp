#pragma once

#include <string>

#include <pugixml.hpp>

#include "line_groups.hpp"
#include "lineatlas/vector.hpp"
#include "sheet.hpp"

namespace lineatlas {

/// An element for paths of one group, with how the style draws them.
pugi::xml_node add_group(pugi::xml_node& svg, const LineGroup& lines, const Sheet& sheet,
                         bool layers);

/// "#rrggbb".
std::string color_text(glm::vec3 color);

} // namespace lineatlas
