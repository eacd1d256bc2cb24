#pragma once

#include <string>
#include <vector>

#include "lineatlas/sheet.hpp"
#include "sheet.hpp"

namespace lineatlas {

/// Throws UsageError for a sheet that no file can hold.
void check_sheet(const VectorSheet& sheet);

/// Where a view's picture lies, in millimetres.
Sheet place_of(const SheetView& view, glm::dvec2 page);

/// A view's name for groups and layers: "front", "view_30_20", "section_A".
std::string name_in_file(const SheetView& view);

/// The style from which the sheet's own lines get their colours: that of the first view.
const Style& style_of(const VectorSheet& sheet);

/// Layers of the sheet's own lines, circles and texts, each once, in order.
std::vector<std::string> own_layers(const SheetLayout& layout);

} // namespace lineatlas
