#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec4.hpp>

#include "frame_output.hpp"
#include "glpasses/canvas.hpp"
#include "io/image_writer.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// How all pictures of one command are drawn.
struct PictureFrame {
    glm::ivec2 size;
    FrameOptions options;
    ImageSettings settings; ///< its description is completed by the camera's
    glm::dvec3 origin{0};   ///< of the lines, in the file's coordinates
    bool transparent = false;
    int tile_size = 0; ///< 0: tiles only for what cannot be drawn in one piece
    /// Told why a picture is drawn by tiles that no limit of the device demands, and where a
    /// style's pens for outlines are of no use.
    std::function<void(const std::string&)> note{};
};

/// Frames as pictures of pixels.
class PictureOutput final : public FrameOutput {
  public:
    PictureOutput(PictureFrame frame, Renderer& renderer, ImageWriter& writer);

    bool draw(const Camera& camera, const std::filesystem::path& path) override;
    void finish() override { writer_.finish(); }
    bool is_whole(const std::filesystem::path& path, glm::ivec2 size) override {
        return writer_.is_whole(path, size);
    }

    /// Draws the frame to the canvas only, for measuring. Drawn by tiles, the last one stays there.
    FrameStats draw(const Camera& camera, const FrameOptions& options);

  private:
    void clear();
    void say_outlines();
    FrameStats draw_whole(const Camera& camera, const std::filesystem::path& path,
                          const ImageSettings& settings);
    FrameStats draw_tiles(const Camera& camera, const std::filesystem::path& path,
                          const ImageSettings& settings);
    /// After draw_whole() has run out of memory, which `why` says: the same by tiles small enough;
    /// nothing if there are none.
    std::optional<FrameStats> draw_smaller(const Camera& camera, const std::filesystem::path& path,
                                           const ImageSettings& settings, std::string_view why);
    /// Copies a tile from the canvas into the band. Tiles come row by row from the top; after the
    /// last one of a row the band is written to the file.
    void take(const PictureTile& tile);
    Pixels pixels(std::span<const std::uint8_t> values) const;
    TileTarget target(std::function<void(const PictureTile&)> end);

    PictureFrame frame_;
    Renderer& renderer_;
    ImageWriter& writer_;
    gl::Canvas canvas_;              ///< for the picture, or for a tile
    std::vector<std::uint8_t> band_; ///< a row of tiles
    bool said_outlines_ = false;
    bool begun_ = false; ///< some of the current picture's tiles are with the writer
};

} // namespace lineatlas
