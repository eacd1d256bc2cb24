#pragma once

#include <vector>

#include "clipped_lines.hpp"
#include "subjects.hpp"

namespace lineatlas::bench {

/// Consecutive frames of a slow camera move, truth included.
struct Burst {
    std::vector<Camera> cameras; ///< the first is the view itself
    double typical_motion = 0;   ///< of visible points from frame to frame, pixels: the median
};

/// `count` frames from `view` on along its path. Their distance is chosen so that 95 of 100 visible
/// points of lines move by less than 0.9 pixels from frame to frame. `lines` and `truth` are those
/// of the first frame.
Burst slow_burst(const PathView& view, const LineSet& set, glm::ivec2 size, std::size_t count,
                 const ClippedLines& lines, const std::vector<float>& truth);

} // namespace lineatlas::bench
