#include "picture_output.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "description.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

/// Colours divided by a small alpha need more than the 8 bits that are left in the end.
int canvas_bits(const PictureFrame& frame) {
    return frame.settings.bits > 8 || frame.transparent ? 16 : 8;
}

/// Tile size of a frame; 0 if it is drawn in one piece.
int tile_size(const PictureFrame& frame) {
    constexpr int most_pixels = 65536; // a side; beyond that floats can't tell texels apart
    if (frame.size.x > most_pixels || frame.size.y > most_pixels) {
        throw UsageError(fmt::format("--size {}x{}: each side must be 1 to {} pixels", frame.size.x,
                                     frame.size.y, most_pixels));
    }
    if (frame.tile_size != 0) return frame.tile_size;
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const int scale = frame.options.method == Method::opengl ? 1 : frame.options.depth_scale;
    if (std::max(frame.size.x, frame.size.y) * scale <= largest) return 0;
    constexpr int depth_texels = 4096; // more take memory, fewer time
    return depth_texels / frame.options.depth_scale;
}

glm::ivec2 canvas_size(const PictureFrame& frame) {
    return frame.tile_size == 0 ? frame.size : glm::min(frame.size, frame.tile_size);
}

PictureFrame with_tiles(PictureFrame frame) {
    frame.tile_size = tile_size(frame);
    return frame;
}

} // namespace

PictureOutput::PictureOutput(PictureFrame frame, Renderer& renderer, ImageWriter& writer)
    : frame_(with_tiles(std::move(frame))), renderer_(renderer), writer_(writer),
      canvas_(canvas_size(frame_), canvas_bits(frame_)) {}

void PictureOutput::clear() {
    canvas_.clear(frame_.transparent ? glm::vec4{0}
                                     : glm::vec4{frame_.options.style.paper.color, 1});
}

/// Copies a tile to its place in the picture, whose first row is the top one.
void PictureOutput::take(const PictureTile& tile) {
    const auto pixel = static_cast<std::size_t>(canvas_.bits() / 2); // bytes
    const std::size_t row = static_cast<std::size_t>(frame_.size.x) * pixel;
    const std::vector<std::uint8_t> part = canvas_.read(tile.size);
    const std::size_t part_row = static_cast<std::size_t>(tile.size.x) * pixel;
    const auto top = static_cast<std::size_t>(frame_.size.y - tile.low.y - tile.size.y);
    std::uint8_t* to = tiled_.data() + top * row + static_cast<std::size_t>(tile.low.x) * pixel;
    for (std::size_t begin = 0; begin < part.size(); begin += part_row, to += row) {
        std::copy_n(part.data() + begin, part_row, to);
    }
}

FrameStats PictureOutput::draw(const Camera& camera, const FrameOptions& options) {
    if (frame_.tile_size == 0) {
        clear();
        return renderer_.draw(camera, options, canvas_.framebuffer());
    }
    tiled_.resize(static_cast<std::size_t>(frame_.size.x) *
                  static_cast<std::size_t>(frame_.size.y) *
                  static_cast<std::size_t>(canvas_.bits() / 2));
    return renderer_.draw_tiles(camera, options,
                                {.framebuffer = canvas_.framebuffer(),
                                 .tile_size = frame_.tile_size,
                                 .begin = [&](const PictureTile&) { clear(); },
                                 .end = [&](const PictureTile& tile) { take(tile); }});
}

void PictureOutput::draw(const Camera& camera, const std::filesystem::path& path) {
    draw(camera, frame_.options);
    ImageSettings settings = frame_.settings;
    settings.description += fmt::format(" {}", describe_camera(camera));
    const std::vector<std::uint8_t> pixels =
        frame_.tile_size == 0 ? canvas_.read() : std::exchange(tiled_, {});
    writer_.write(path,
                  {.size = frame_.size,
                   .channels = 4,
                   .bits = canvas_.bits(),
                   .premultiplied = true,
                   .values = std::as_bytes(std::span{pixels})},
                  settings);
}

} // namespace lineatlas::apps
