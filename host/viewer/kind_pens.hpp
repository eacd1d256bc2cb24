#pragma once

#include <string>
#include <string_view>

#include "lineatlas/style.hpp"

// Pens of single kinds of line and of single objects, as rules of the style. `kind`: a name
// that PenMatch::kinds knows; `object`: a MeshGroup::object.
namespace lineatlas::viewer {

/// The pen of a kind by the rules that name no object and no material. Only its width and colour
/// are used.
Pen pen_of_kind(const Style& style, std::string_view kind);

/// Sets the width or colour of a kind. Rules for outlines, objects and materials still count more.
void set_width_of_kind(Style& style, std::string_view kind, float width);
void set_color_of_kind(Style& style, std::string_view kind, glm::vec3 color);

/// The pen of all lines of an object by the rules that name no outline and no single kind.
Pen pen_of_object(const Style& style, const std::string& object);
/// Sets the width or colour of an object. This counts more than all other rules of the style.
void set_width_of_object(Style& style, const std::string& object, float width);
void set_color_of_object(Style& style, const std::string& object, glm::vec3 color);

} // namespace lineatlas::viewer
