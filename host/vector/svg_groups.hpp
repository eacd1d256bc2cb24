#pragma once

#include <string>

#include "lineatlas/vector.hpp"
#include "outline.hpp"
#include "sheet.hpp"
#include "xml.hpp"

namespace lineatlas {

/// How paths stand in an SVG.
struct SvgPaths {
    bool tags = true;   ///< where each path comes from
    bool layers = true; ///< mark groups as layers of Inkscape
    bool relative = true;
    ArcChoice arcs{};
    std::string prefix{}; ///< of names of groups
};

/// Adds a group for the fills, if there are any, then one for the paths of each pen, and the paths.
void write_paths(XmlElement& parent, const VectorDrawing& drawing, const Sheet& sheet,
                 const SvgPaths& how);

/// "#rrggbb".
std::string color_text(glm::vec3 color);

} // namespace lineatlas
