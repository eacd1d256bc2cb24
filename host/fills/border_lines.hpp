#pragma once

#include <cstdint>
#include <span>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The triangles of `lines`, with the edges as segments at which the look of what `camera` sees may
/// change: borders of surfaces, edges between a front and a back face, edges between different
/// looks (per triangle in `looks`), and intersections.
LineSet border_lines(const LineSet& lines, std::span<const std::uint32_t> looks,
                     const Camera& camera);

} // namespace lineatlas
