#pragma once

#include "sheet_marks.hpp"

namespace lineatlas {

/// The contents of a title block in addition to its fields.
struct TitleBlockFacts {
    std::string scale; ///< "1:2"
    std::string page;  ///< "A3"; empty: a page without a name
    ProjectionAngle angle = ProjectionAngle::third;
};

/// Where the title block stands: in the lower right corner of the frame, 180 mm wide (ISO 7200), or
/// as wide as a frame that is narrower.
SheetBox title_block_of(const SheetBox& frame);

/// Draws it.
void add_title_block(SheetLayout& layout, const SheetBox& block, const SheetFields& fields,
                     const TitleBlockFacts& facts);

} // namespace lineatlas
