#pragma once

#include "sheet_marks.hpp"

namespace lineatlas {

/// The contents of a title block in addition to its fields.
struct TitleBlockFacts {
    std::string scale; ///< "1:2"
    std::string page;  ///< "A3"; empty: a page without a name
    ProjectionAngle angle = ProjectionAngle::third;
};

/// The place of the title block: the lower right corner of the frame, 180 mm wide (ISO 7200), or as
/// wide as the frame if that is narrower.
SheetBox title_block_of(const SheetBox& frame);

/// Draws the title block.
void add_title_block(SheetLayout& layout, const SheetBox& block, const SheetFields& fields,
                     const TitleBlockFacts& facts);

} // namespace lineatlas
