#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// Per triangle the number of its smooth patch. Two triangles are of one patch if one can be
/// reached from the other across edges of exactly two triangles that no line separates.
/// Silhouettes, tangent edges and lines within surfaces (LA_KINDS_WITHIN) separate nothing. The
/// number of a patch is that of its first triangle. `segments` must be of every kind: a line that
/// is left out does not separate patches.
std::vector<std::uint32_t> smooth_patches(std::span<const glm::uvec3> triangles,
                                          std::span<const Segment> segments);
inline std::vector<std::uint32_t> smooth_patches(const LineSet& lines) {
    return smooth_patches(lines.triangles, lines.segments);
}

} // namespace lineatlas
