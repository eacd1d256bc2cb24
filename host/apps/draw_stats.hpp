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
/// whole, the others by stages, with a wait after each; the last one is by stages.
void measure_and_print(MeasuredFrame frame, const Renderer& renderer);

} // namespace lineatlas::apps
