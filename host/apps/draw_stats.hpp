#pragma once

#include <functional>
#include <string>

#include "lineatlas/lines.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas::apps {

/// The frame that `--stats` measures.
struct MeasuredFrame {
    std::string name; ///< of the model
    const LineSet& lines;
    FrameOptions options;
    int repeat;
    std::function<FrameStats(const FrameOptions&)> draw;
};

/// Draws `repeat` frames and prints counts, memory and median times. Every other frame is drawn
/// whole. The others, and so the last one, are drawn by stages with a wait after each.
void measure_and_print(MeasuredFrame frame, const Renderer& renderer);

} // namespace lineatlas::apps
