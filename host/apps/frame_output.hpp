#pragma once

#include <filesystem>

#include "lineatlas/camera.hpp"

namespace lineatlas::apps {

/// Draws frames to files of one kind; which kind, the extension of the output says.
class FrameOutput {
  public:
    virtual ~FrameOutput() = default;

    /// Draws what `camera` sees to a file, which is there whole after finish() at the latest, or
    /// not at all. Throws Error, of this frame or the one before.
    virtual void draw(const Camera& camera, const std::filesystem::path& path) = 0;
    /// Waits for the last file. Throws Error.
    virtual void finish() = 0;
    /// Whether `path` already holds a frame of that size, whole.
    virtual bool is_whole(const std::filesystem::path& path, glm::ivec2 size) = 0;
};

} // namespace lineatlas::apps
