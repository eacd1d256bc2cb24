#pragma once

#include <vector>

#include "lineatlas/style.hpp"
#include "sheet.hpp"

namespace lineatlas {

/// The properties of a pen in formats that know only widths, caps, joins and dashes. Lengths are in
/// units of the sheet.
struct PenStroke {
    glm::vec3 color;
    double opacity;
    double width;
    Join join;
    double mitre_limit;
    bool round;                 ///< caps, those of dashes included, are round; false: cut square
    std::vector<double> dashes; ///< on, off and so on; empty: none
};

PenStroke pen_stroke(const Pen& pen, const Sheet& sheet);

/// The length of the pattern that a line of dashes and dots leaves out at its start, so that the
/// middle of the line, where others cross it, lies in a dash (ISO 128-2). 0 for dashes alone.
double dash_offset(const PenStroke& stroke, double length);

} // namespace lineatlas
