#pragma once

#include <cstdint>
#include <span>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The triangles of `lines`, with those edges as segments at which what `camera` sees may change
/// its look: borders of surfaces, edges between a front and a back face, edges between different
/// looks (per triangle in `looks`), and intersections.
LineSet border_lines(const LineSet& lines, std::span<const std::uint32_t> looks,
                     const Camera& camera);

} // namespace lineatlas
