#include "pen_stroke.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/pens.hpp"

namespace lineatlas {

PenStroke pen_stroke(const Pen& pen, const Sheet& sheet) {
    const auto length = [&](float pixels) { return static_cast<double>(pixels) * sheet.scale; };
    PenStroke stroke{.color = pen.color,
                     .opacity = static_cast<double>(pen.opacity),
                     .width = length(pen.width),
                     .join = pen.join,
                     .mitre_limit = static_cast<double>(pen.mitre_limit),
                     .round = pen.path_cap == Cap::round, // tapers and worn ends are cut square
                     .dashes = {}};
    if (const std::optional<DashLengths> marks = dash_lengths(pen.mark, pen.width)) {
        stroke.dashes = {length(marks->dash), length(marks->gap)};
        if (marks->dot > 0)
            stroke.dashes.insert(stroke.dashes.end(), {length(marks->dot), length(marks->gap)});
        stroke.round = marks->round;
    }
    return stroke;
}

double dash_scale(const PenStroke& stroke, double length, bool closed) {
    if (stroke.dashes.empty() || stroke.round) return 1;
    const bool has_dots = stroke.dashes.size() > 2;
    const double least = has_dots ? 0.5 : 0.25; // with less, dots or gaps are lost
    const double period = std::accumulate(stroke.dashes.begin(), stroke.dashes.end(), 0.0);
    const double end = closed ? 0 : stroke.dashes.front(); // the dash behind the last pattern
    // Patterns: with an even number a dash is in the middle.
    const double step = has_dots && !closed ? 2 : 1;
    const double below = step * std::floor(std::max(0.0, length - end) / (step * period));
    // Of the numbers below and above the one by which the scale is nearer to 1.
    const double wide = length / (below * period + end);
    const double narrow = length / ((below + step) * period + end);
    const double scale = below > 0 && wide * narrow < 1 ? wide : narrow;
    return scale < least ? 0 : scale;
}

double dash_scale(const PenStroke& stroke, const Outline& outline) {
    return stroke.dashes.empty() ? 1 : dash_scale(stroke, length_of(outline), outline.closed);
}

} // namespace lineatlas
