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
    ImageSettings settings; ///< the camera is added to its description
    glm::dvec3 origin{0};   ///< origin of the lines, in the file's coordinates
    bool transparent = false;
    int tile_size = 0; ///< 0: tiles only if the picture cannot be drawn in one piece
    /// Called with notes: why a picture is drawn by tiles although no limit of the device demands
    /// it, and that a style's pens for outlines have no effect.
    std::function<void(const std::string&)> note{};
    /// Asked before each tile, and before a picture in one piece is written. After false draw()
    /// throws Cancelled, and nothing is written.
    std::function<bool()> goes_on{};
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

    /// Draws the frame to the canvas only, for measuring. If it is drawn by tiles, the last tile
    /// stays there.
    FrameStats draw(const Camera& camera, const FrameOptions& options);

  private:
    void clear();
    void say_outlines();
    FrameStats draw_whole(const Camera& camera, const std::filesystem::path& path,
                          const ImageSettings& settings);
    FrameStats draw_tiles(const Camera& camera, const std::filesystem::path& path,
                          const ImageSettings& settings);
    /// Draws by tiles that are small enough, after draw_whole() has run out of memory. `why`: the
    /// message of that error. Returns nothing if no tile is small enough.
    std::optional<FrameStats> draw_smaller(const Camera& camera, const std::filesystem::path& path,
                                           const ImageSettings& settings, std::string_view why);
    /// Copies a tile from the canvas into the band. Tiles come row by row from the top; after the
    /// last one of a row the band is written to the file.
    void take(const PictureTile& tile);
    Pixels pixels(std::span<const std::uint8_t> values) const;
    bool goes_on() const { return !frame_.goes_on || frame_.goes_on(); }
    TileTarget target(std::function<void(const PictureTile&)> end);

    PictureFrame frame_;
    Renderer& renderer_;
    ImageWriter& writer_;
    gl::Canvas canvas_;              ///< for the picture, or for a tile
    std::vector<std::uint8_t> band_; ///< a row of tiles
    bool said_outlines_ = false;
    bool begun_ = false; ///< the writer has some tiles of the current picture
};

} // namespace lineatlas
