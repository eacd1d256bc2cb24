#pragma once

#include <functional>

#include "core/progress.hpp"
#include "frame.hpp"

namespace lineatlas {

/// Draws a picture tile by tile (Renderer::draw_tiles()): `draw` draws lines and fills into
/// Frame::tile. Throws Cancelled.
void draw_by_tiles(Frame& frame, const TileTarget& target, const ProgressPart& progress,
                   const std::function<void()>& draw);

} // namespace lineatlas
