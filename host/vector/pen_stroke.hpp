#pragma once

#include <vector>

#include "lineatlas/style.hpp"
#include "outline.hpp"
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

/// The scale of a line's dashes and gaps, with which the line begins and ends with a dash. A line
/// with dots has a dash in its middle, too, where others cross it (ISO 128-2). A closed line has
/// whole patterns. 0: the line is too short for that, and has no gaps. 1 for rows of dots.
double dash_scale(const PenStroke& stroke, double length, bool closed);
/// The same for an outline, measured along its curves.
double dash_scale(const PenStroke& stroke, const Outline& outline);

} // namespace lineatlas
