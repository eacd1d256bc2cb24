#pragma once

#include <string>

#include <glm/vec2.hpp>
#include <pugixml.hpp>

#include "lineatlas/style.hpp"

namespace lineatlas {

void set(pugi::xml_node& node, const char* name, const std::string& value);

/// A child element with a text; characters that XML cannot hold are left out.
void add_text(pugi::xml_node& node, const char* name, const std::string& text);

/// Makes a group a layer of Inkscape.
void mark_layer(pugi::xml_node& group, const std::string& label);

struct SvgPage {
    std::string unit; ///< "mm", of the page and of all coordinates
    int digits;       ///< after the point
    bool layers;      ///< marks of Inkscape are to come
};

/// The root of a document of this size.
pugi::xml_node add_svg(pugi::xml_document& document, glm::dvec2 size, const SvgPage& page);

/// The paper's colour, unless it is white.
void add_background(pugi::xml_node& svg, const Style& style, glm::dvec2 size, int digits);

/// The document as a file has it.
std::string svg_text(const pugi::xml_document& document);

} // namespace lineatlas
