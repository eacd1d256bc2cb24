#pragma once

#include <optional>

#include "lineatlas/style.hpp"
#include "sheet.hpp"

namespace lineatlas {

/// The properties of a pen in formats that know only widths, caps, joins and dashes. Lengths are in
/// units of the sheet.
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
