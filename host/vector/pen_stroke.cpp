#include "pen_stroke.hpp"

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

double dash_offset(const PenStroke& stroke, double length) {
    if (stroke.dashes.size() <= 2) return 0;
    const double period = std::accumulate(stroke.dashes.begin(), stroke.dashes.end(), 0.0);
    const double offset = std::fmod(0.5 * (stroke.dashes.front() - length), period);
    return offset < 0 ? offset + period : offset;
}

} // namespace lineatlas
