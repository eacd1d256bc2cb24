#pragma once

#include <string>

#include <glm/vec4.hpp>

#include "frame_output.hpp"
#include "glpasses/canvas.hpp"
#include "io/image_writer.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas::apps {

/// How all pictures of one command are drawn.
struct PictureFrame {
    glm::ivec2 size;
    FrameOptions options;
    ImageSettings settings; ///< its description is completed by the camera's
    bool transparent = false;
};

/// Frames as pictures of pixels.
class PictureOutput final : public FrameOutput {
  public:
    PictureOutput(PictureFrame frame, Renderer& renderer, ImageWriter& writer);

    void draw(const Camera& camera, const std::filesystem::path& path) override;
    void finish() override { writer_.finish(); }
    bool is_whole(const std::filesystem::path& path, glm::ivec2 size) override {
        return writer_.is_whole(path, size);
    }

    /// Draws the frame and leaves it on the canvas.
    FrameStats draw(const Camera& camera, const FrameOptions& options);

  private:
    PictureFrame frame_;
    Renderer& renderer_;
    ImageWriter& writer_;
    gl::Canvas canvas_;
};

} // namespace lineatlas::apps
