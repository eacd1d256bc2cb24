#pragma once

#include <vector>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::test {

/// The depth of a line set's triangles, drawn by GL: floats, rows from the lower left. `scale`:
/// texels per pixel and axis.
std::vector<float> draw_depth_by_gl(const LineSet& lines, const Camera& camera, int scale);

} // namespace lineatlas::test
