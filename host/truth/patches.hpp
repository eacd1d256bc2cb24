#pragma once

#include <cstdint>
#include <vector>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// Per triangle the number of its smooth patch: two triangles are of one where one can be reached
/// from the other across edges of exactly two triangles that are no lines whatever the camera.
/// Numbers are those of a patch's first triangle. `lines` must have been extracted with every kind,
/// since a line that is left out does not part patches.
std::vector<std::uint32_t> smooth_patches(const LineSet& lines);

} // namespace lineatlas
