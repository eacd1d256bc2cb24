#include "sheet_writing.hpp"

#include <algorithm>

#include "check_drawing.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {

void check_sheet(const VectorSheet& sheet) {
    if (sheet.drawings.empty() || sheet.drawings.size() != sheet.layout.views.size())
        throw UsageError("sheet: there must be a drawing for each view; there are " +
                         std::to_string(sheet.drawings.size()) + " for " +
                         std::to_string(sheet.layout.views.size()));
    for (const VectorDrawing& drawing : sheet.drawings) check_drawing(drawing);
    for (const SheetLine& line : sheet.layout.lines)
        if (line.points.size() < 2)
            throw UsageError("sheet: a line of its own must have two points at least");
}

Sheet place_of(const SheetView& view, glm::dvec2 page) {
    constexpr int digits = 4; // a tenth of a micrometre
    return {.size = page, .scale = view.scale, .corner = view.corner, .digits = digits};
}

std::string name_in_file(const SheetView& view) {
    if (view.cut && !view.detail) return std::string{"section_"}.append(view.letter);
    std::string name = view.name;
    std::ranges::replace(name, ',', '_');
    const bool is_word = !name.empty() && name.front() >= 'a' && name.front() <= 'z';
    if (!is_word) name.insert(0, "view_");
    return name;
}

const Style& style_of(const VectorSheet& sheet) {
    return sheet.drawings.front().style;
}

std::vector<std::string> own_layers(const SheetLayout& layout) {
    std::vector<std::string> layers;
    const auto add = [&](const auto& marks) {
        for (const auto& mark : marks)
            if (std::ranges::find(layers, mark.layer) == layers.end()) layers.push_back(mark.layer);
    };
    add(layout.lines);
    add(layout.circles);
    add(layout.texts);
    return layers;
}

} // namespace lineatlas
