#include <utility>

#include "core/style_lengths.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/sheet.hpp"
#include "sheet_measures.hpp"
#include "sheet_pixels.hpp"

namespace lineatlas {

Style style_of_view(const Style& style, const SheetView& view) {
    Style result = style;
    multiply_lengths(result, static_cast<float>(length_in({1, Unit::px}, Unit::mm) * sheet_pixels));
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
            throw UsageError("sheet: " + view.name + " needs the lines of the cut model");
        VectorOptions own = options;
        own.outlines = seen.outlines;
        if (seen.lines != nullptr) own.mesh = seen.mesh;
        sheet.drawings.push_back(make_vector_drawing(seen.lines == nullptr ? lines : *seen.lines,
                                                     view.camera, seen.intervals,
                                                     style_of_view(style, view), own));
        sheet.drawings.back().fills = std::move(seen.fills);
    }
    if (layout.measures) add_measures(sheet);
    return sheet;
}

} // namespace lineatlas
