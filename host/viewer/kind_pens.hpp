#pragma once

#include <string>
#include <string_view>

#include "lineatlas/style.hpp"

// Pens of single kinds of line and of single objects, as rules of the style. `kind`: a name
// that PenMatch::kinds knows; `object`: a MeshGroup::object.
namespace lineatlas::viewer {

/// What the style draws a kind with, objects and materials aside: its width and colour.
Pen pen_of_kind(const Style& style, std::string_view kind);

/// From now on; the outline and rules for objects and materials still count more.
void set_width_of_kind(Style& style, std::string_view kind, float width);
void set_color_of_kind(Style& style, std::string_view kind, glm::vec3 color);

/// What the style draws all lines of an object with, its outline and single kinds aside.
Pen pen_of_object(const Style& style, const std::string& object);
/// Counts more than all else that the style says.
void set_width_of_object(Style& style, const std::string& object, float width);
void set_color_of_object(Style& style, const std::string& object, glm::vec3 color);

} // namespace lineatlas::viewer
