#pragma once

#include <optional>

#include "lineatlas/style.hpp"
#include "sheet.hpp"

namespace lineatlas {

/// What a stroke keeps of its pen where one knows widths, caps, joins and dashes alone. Lengths are
/// in units of the sheet.
struct PenStroke {
    struct Dashes {
        double dash, gap;
    };

    glm::vec3 color;
    double opacity;
    double width;
    Join join;
    double mitre_limit;
    bool round; ///< its caps, those of dashes included: one for both; else cut square
    std::optional<Dashes> dashes;
};

PenStroke pen_stroke(const Pen& pen, const Sheet& sheet);

} // namespace lineatlas
