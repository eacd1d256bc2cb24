#include "pen_stroke.hpp"

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
        stroke.round = marks->round;
    }
    return stroke;
}

} // namespace lineatlas
