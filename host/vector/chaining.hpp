#pragma once

#include <vector>

#include "core/line_pens.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"
#include "pieces.hpp"
#include "strips.hpp"

namespace lineatlas {

/// The pens of lines.
struct PathPens {
    const LineClasses& classes;
    const LinePens& pens;
};

/// Makes a polyline of every stroke of every strip. A stroke that goes on across the seam of a
/// closed strip is one polyline, closed if it goes all around. Where another pen goes on, another
/// polyline begins. pens: null if one pen draws all.
std::vector<VectorPath> chain_strips(const LineSet& lines, const Pieces& pieces,
                                     const std::vector<Strip>& strips, const PathPens* pens);

} // namespace lineatlas
