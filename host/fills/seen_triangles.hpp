#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// No triangle.
inline constexpr std::uint32_t no_triangle = 0xFFFFFFFF;

/// Returns the triangle that `camera` sees at each point, in pixels from the upper left corner, or
/// no_triangle. Of triangles in one place it sees the first.
std::vector<std::uint32_t> seen_triangles(const LineSet& lines, const Camera& camera,
                                          std::span<const glm::dvec2> points);

} // namespace lineatlas
