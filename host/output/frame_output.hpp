#pragma once

#include <filesystem>
#include <string>

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// Draws frames to files of one kind: pictures of pixels, or paths.
class FrameOutput {
  public:
    virtual ~FrameOutput() = default;

    /// Draws what `camera` sees to a file. The file may be written later, by finish() at the
    /// latest. It appears whole or not at all. Returns false if it is known that no line is drawn.
    /// Throws Error, which may be about the frame before.
    virtual bool draw(const Camera& camera, const std::filesystem::path& path) = 0;
    /// Waits until the last file is written. Throws Error.
    virtual void finish() = 0;
    /// Whether `path` already holds a whole frame of this size.
    virtual bool is_whole(const std::filesystem::path& path, glm::ivec2 size) = 0;
    /// A line about the drawing, for the user; empty: nothing to say.
    virtual std::string note() const { return {}; }
};

} // namespace lineatlas
