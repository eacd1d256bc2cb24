#include "check_drawing.hpp"

#include <algorithm>
#include <string>

#include "core/picture_size.hpp"
#include "lineatlas/error.hpp"
#include "style/settings.hpp"

namespace lineatlas {
namespace {

void check_pen(const Pen& pen, Style& style) {
    style.pen = pen;
    // Lengths are those of the picture (Style::made_for), which may be longer than any in a style.
    style.pen.width = std::min(pen.width, Pen{}.width);
    style.pen.cap_length = std::min(pen.cap_length, Pen{}.cap_length);
    check_style(style);
}

void check_curves(const VectorPath& path) {
    std::uint32_t before = 0;
    for (const VectorCurve& curve : path.curves) {
        if (curve.first < before || curve.last <= curve.first || curve.last >= path.points.size())
            throw UsageError("drawing: a path's curve goes from point " +
                             std::to_string(curve.first) + " to " + std::to_string(curve.last) +
                             ", but it has " + std::to_string(path.points.size()) +
                             ", of which others begin at " + std::to_string(before));
        before = curve.last;
    }
}

} // namespace

void check_drawing(const VectorDrawing& drawing) {
    check_picture(drawing.size);
    Style style;
    style.paper = drawing.style.paper;
    for (const Pen* own : {&drawing.style.pen, &drawing.style.hidden_pen}) check_pen(*own, style);
    for (const auto* pens : {&drawing.pens, &drawing.hidden_pens})
        for (const Pen& pen : *pens) check_pen(pen, style);
    for (const VectorPath& path : drawing.paths) {
        check_curves(path);
        const std::size_t pens = path.visible ? drawing.pens.size() : drawing.hidden_pens.size();
        if (path.pen == 0 || path.pen < pens) continue;
        throw UsageError("drawing: a path has the pen " + std::to_string(path.pen) +
                         ", but there are " + std::to_string(pens));
    }
}

} // namespace lineatlas
