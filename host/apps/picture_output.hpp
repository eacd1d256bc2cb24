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
    int tile_size = 0; ///< 0: tiles only for what GL cannot draw in one piece
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

    /// Draws the frame and leaves it on the canvas; of tiles, the last one.
    FrameStats draw(const Camera& camera, const FrameOptions& options);

  private:
    void clear();
    void draw_whole(const Camera& camera, const std::filesystem::path& path,
                    const ImageSettings& settings);
    void draw_tiles(const Camera& camera, const std::filesystem::path& path,
                    const ImageSettings& settings);
    /// Tiles come in rows from the top: a row that is complete is a band of the picture.
    void take(const PictureTile& tile);
    Pixels pixels(std::span<const std::uint8_t> values) const;
    TileTarget target(std::function<void(const PictureTile&)> end);

    PictureFrame frame_;
    Renderer& renderer_;
    ImageWriter& writer_;
    gl::Canvas canvas_;              ///< for the picture, or for a tile
    std::vector<std::uint8_t> band_; ///< a row of tiles
};

} // namespace lineatlas::apps
