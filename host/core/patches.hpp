#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// Per triangle the number of its smooth patch: two triangles are of one where one can be reached
/// from the other across edges of exactly two triangles that are no lines whatever the camera.
/// Numbers are those of a patch's first triangle. `segments` must be of every kind: a line that is
/// left out does not part patches.
std::vector<std::uint32_t> smooth_patches(std::span<const glm::uvec3> triangles,
                                          std::span<const Segment> segments);
inline std::vector<std::uint32_t> smooth_patches(const LineSet& lines) {
    return smooth_patches(lines.triangles, lines.segments);
}

} // namespace lineatlas
