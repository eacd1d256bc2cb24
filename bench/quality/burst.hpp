#pragma once

#include <vector>

#include "clipped_lines.hpp"
#include "subjects.hpp"

namespace lineatlas::bench {

/// The cameras of consecutive frames of a slow move.
struct Burst {
    std::vector<Camera> cameras; ///< the first is that of the view
    double typical_motion = 0;   ///< median motion of visible points from frame to frame, in pixels
};

/// `count` frames along the path, the first at `view`. Their distance lets 95 of 100 visible points
/// of lines move by less than 0.9 pixels from frame to frame. `lines` and `truth` are those of the
/// first frame.
Burst slow_burst(const PathView& view, const LineSet& set, glm::ivec2 size, std::size_t count,
                 const ClippedLines& lines, const std::vector<float>& truth);

} // namespace lineatlas::bench
