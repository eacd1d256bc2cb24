#pragma once

#include "sheet_marks.hpp"

namespace lineatlas {

/// The space for drawing within the frame of a page (ISO 5457). Throws UsageError for a page that
/// is too small for one.
SheetBox frame_of(glm::dvec2 page);

/// Draws the frame with its centring marks and its grid of references.
void add_frame(SheetLayout& layout);

} // namespace lineatlas
