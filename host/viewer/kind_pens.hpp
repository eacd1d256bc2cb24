#pragma once

#include <string_view>

#include "lineatlas/style.hpp"

// Pens of kinds of line, as rules of the style for that kind alone. `kind`: a name that
// PenMatch::kinds knows.
namespace lineatlas::viewer {

/// What the style draws a kind with, objects and materials aside: its width and colour.
Pen pen_of_kind(const Style& style, std::string_view kind);

/// From now on; the outline and rules for objects and materials still count more.
void set_width_of_kind(Style& style, std::string_view kind, float width);
void set_color_of_kind(Style& style, std::string_view kind, glm::vec3 color);

} // namespace lineatlas::viewer
