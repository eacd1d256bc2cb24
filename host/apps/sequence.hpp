#pragma once

#include <filesystem>
#include <span>

#include "output/frame_output.hpp"

namespace lineatlas::apps {

struct SequenceFrame {
    int number;
    std::filesystem::path path;
    Camera camera;
};

/// Draws the frames in their order, with progress on standard error. `resume`: frames whose files
/// exist and are whole are skipped. Throws Stopped after SIGINT or SIGTERM, between two frames,
/// when every file that was begun is whole. Throws Error.
void draw_sequence(std::span<const SequenceFrame> frames, FrameOutput& output, bool resume);

} // namespace lineatlas::apps
