#pragma once

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"
#include "pieces.hpp"

namespace lineatlas {

/// Hides pieces of less than a pixel that are visible from a corner on, if a flat face at that
/// corner hides the line from there on. By the exact method a line touches a face that is before it
/// by less than LineSet::precision allows (core/contact.hpp), and so seems to be visible a little
/// beyond the corner. Nothing changes where that precision is 0.
void hide_beyond_corners(const LineSet& lines, const Camera& camera, Pieces& pieces);

} // namespace lineatlas
