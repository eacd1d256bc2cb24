#pragma once

#include <string>

#include <glm/vec4.hpp>

#include "glpasses/canvas.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas::apps {

/// The frame that `--stats` measures.
struct MeasuredFrame {
    std::string name; ///< of the model
    Camera camera;
    FrameOptions options;
    glm::vec4 paper;
    int repeat;
};

/// Draws `repeat` frames and prints counts, memory and median times.
void measure_and_print(MeasuredFrame frame, Renderer& renderer, gl::Canvas& canvas);

} // namespace lineatlas::apps
