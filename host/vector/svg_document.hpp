#pragma once

#include <string>

#include <glm/vec2.hpp>

#include "lineatlas/style.hpp"
#include "xml.hpp"

namespace lineatlas {

/// A child element with a text; characters that XML cannot hold are left out.
void add_text(XmlElement& node, const char* name, const std::string& text);

/// Makes a group a layer of Inkscape.
void mark_layer(XmlElement& group, const std::string& label);

struct SvgPage {
    std::string unit; ///< "mm", of the page and of all coordinates
    int digits;       ///< after the point
    bool layers;      ///< with marks for layers of Inkscape
};

/// The root of a document of this size.
XmlElement svg_root(glm::dvec2 size, const SvgPage& page);

/// Adds a rectangle in the paper's colour, unless that is white.
void add_background(XmlElement& svg, const Style& style, glm::dvec2 size, int digits);

} // namespace lineatlas
