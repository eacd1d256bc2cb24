#include <utility>

#include "clip_drawing.hpp"
#include "core/style_lengths.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/sheet.hpp"
#include "sheet_measures.hpp"
#include "sheet_pixels.hpp"

namespace lineatlas {
namespace {

/// Leaves what lies in the circle of a detail.
void clip_to_circle(const SheetView& view, VectorDrawing& drawing) {
    const glm::dvec2 middle = 0.5 * (view.low + view.high);
    clip_to_circle(drawing, (middle - view.corner) / view.scale,
                   0.5 * (view.high.x - view.low.x) / view.scale);
}

} // namespace

Style style_of_view(const Style& style, const SheetView& view) {
    Style result = style;
    const double pixels = view.detail ? 1 / view.scale : sheet_pixels; // per millimetre
    multiply_lengths(result, static_cast<float>(length_in({1, Unit::px}, Unit::mm) * pixels));
    if (view.pictorial || view.cut) result.hidden = false;
    return result;
}

VectorSheet make_vector_sheet(const LineSet& lines, const SheetLayout& layout,
                              const FindViewLines& find, const Style& style,
                              const VectorOptions& options) {
    VectorSheet sheet{.layout = layout, .drawings = {}};
    for (const SheetView& view : layout.views) {
        SeenLines seen = find(view);
        if (view.cut && seen.lines == nullptr)
            throw UsageError(view.name + ": a section needs the lines of the cut model");
        VectorOptions own = options;
        own.outlines = seen.outlines;
        if (seen.lines != nullptr) own.mesh = seen.mesh;
        sheet.drawings.push_back(make_vector_drawing(seen.lines == nullptr ? lines : *seen.lines,
                                                     view.camera, seen.intervals,
                                                     style_of_view(style, view), own));
        sheet.drawings.back().fills = std::move(seen.fills);
        if (view.detail) clip_to_circle(view, sheet.drawings.back());
    }
    if (layout.measures) add_measures(sheet);
    return sheet;
}

} // namespace lineatlas
