#include "picture_output.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "core/limits.hpp"
#include "core/line_pens.hpp"
#include "describe_camera.hpp"
#include "lineatlas/progress.hpp"

namespace lineatlas {
namespace {

/// Bits of the canvas. Colours are divided by alpha, and a small alpha needs more than the 8 bits
/// of the file.
int canvas_bits(const PictureFrame& frame) {
    return frame.settings.bits > 8 || frame.transparent ? 16 : 8;
}

glm::ivec2 canvas_size(const PictureFrame& frame) {
    return frame.tile_size == 0 ? frame.size : glm::min(frame.size, frame.tile_size);
}

PictureFrame with_tiles(PictureFrame frame, const Renderer& renderer) {
    if (frame.tile_size == 0) frame.tile_size = renderer.tile_size(frame.size, frame.options);
    return frame;
}

/// The reason why a style's pen for outlines is drawn nowhere; empty if there is none.
std::string outline_note(const PictureFrame& frame) {
    const Method method = frame.options.method;
    const bool in_tiles = method == Method::atlas && frame.tile_size != 0;
    const bool known = method == Method::exact || (method == Method::atlas && !in_tiles);
    if (known || !tells_outlines(frame.options.style)) return {};
    return fmt::format("outlines are drawn as other lines: {} does not tell them; --method exact "
                       "does",
                       in_tiles ? "a picture in tiles by atlas" : "this method");
}

} // namespace

PictureOutput::PictureOutput(PictureFrame frame, Renderer& renderer, ImageWriter& writer)
    : frame_(with_tiles(std::move(frame), renderer)), renderer_(renderer), writer_(writer),
      canvas_(canvas_size(frame_), canvas_bits(frame_)) {
    say_outlines();
}

void PictureOutput::say_outlines() {
    const std::string text = outline_note(frame_);
    if (said_outlines_ || text.empty() || !frame_.note) return;
    frame_.note(text);
    said_outlines_ = true;
}

void PictureOutput::clear() {
    canvas_.clear(frame_.transparent ? glm::vec4{0}
                                     : glm::vec4{frame_.options.style.paper.color, 1});
}

Pixels PictureOutput::pixels(std::span<const std::uint8_t> values) const {
    return {.size = frame_.size,
            .channels = 4,
            .bits = canvas_.bits(),
            .premultiplied = true,
            .values = std::as_bytes(values)};
}

TileTarget PictureOutput::target(std::function<void(const PictureTile&)> end) {
    return {.framebuffer = canvas_.framebuffer(),
            .tile_size = frame_.tile_size,
            .begin = [this](const PictureTile&) { clear(); },
            .end = std::move(end),
            .progress = frame_.goes_on ? [this](float done) { return done >= 1 || goes_on(); }
                                       : Progress{}}; // at 1 the writer has the whole picture
}

FrameStats PictureOutput::draw(const Camera& camera, const FrameOptions& options) {
    if (frame_.tile_size != 0) {
        return renderer_.draw_tiles(camera, options, target([](const PictureTile&) {}));
    }
    clear();
    return renderer_.draw(camera, options, canvas_.framebuffer());
}

void PictureOutput::take(const PictureTile& tile) {
    const auto pixel = static_cast<std::size_t>(canvas_.bits() / 2); // bytes
    const std::size_t row = static_cast<std::size_t>(frame_.size.x) * pixel;
    const std::size_t part_row = static_cast<std::size_t>(tile.size.x) * pixel;
    const std::vector<std::uint8_t> part = canvas_.read(tile.size);
    band_.resize(row * static_cast<std::size_t>(tile.size.y));
    std::size_t to = static_cast<std::size_t>(tile.low.x) * pixel;
    for (std::size_t from = 0; from < part.size(); from += part_row, to += row) {
        std::copy_n(part.data() + from, part_row, band_.data() + to);
    }
    if (tile.low.x + tile.size.x == frame_.size.x) {
        writer_.append(std::as_bytes(std::span{band_}));
    }
}

FrameStats PictureOutput::draw_tiles(const Camera& camera, const std::filesystem::path& path,
                                     const ImageSettings& settings) {
    begun_ = false;
    try {
        return renderer_.draw_tiles(camera, frame_.options, target([&](const PictureTile& tile) {
                                        if (!begun_) writer_.begin(path, pixels({}), settings);
                                        begun_ = true;
                                        take(tile);
                                    }));
    } catch (...) {
        if (begun_) writer_.abandon();
        throw;
    }
}

std::optional<FrameStats> PictureOutput::draw_smaller(const Camera& camera,
                                                      const std::filesystem::path& path,
                                                      const ImageSettings& settings,
                                                      std::string_view why) {
    constexpr int smallest_tile = 64;
    const FrameOptions& options = frame_.options;
    const bool by_tiles =
        options.method == Method::exact ||
        (options.method == Method::atlas && options.forms.atlas != StageForm::raster);
    if (!by_tiles) return {};
    int side = std::max(frame_.size.x, frame_.size.y);
    while (side > smallest_tile) {
        side = std::max(side / 2, smallest_tile);
        frame_.tile_size = side;
        canvas_ = gl::Canvas{canvas_size(frame_), canvas_bits(frame_)};
        try {
            FrameStats stats = draw_tiles(camera, path, settings);
            if (frame_.note)
                frame_.note(fmt::format("drawn in tiles of {0}x{0} pixels: in one piece {1}", side,
                                        why.substr(0, why.find("; use "))));
            say_outlines();
            return stats;
        } catch (const OutOfMemory&) {
            if (begun_) throw; // the writer already has a part of the picture
        }
    }
    return {};
}

FrameStats PictureOutput::draw_whole(const Camera& camera, const std::filesystem::path& path,
                                     const ImageSettings& settings) {
    try {
        FrameStats stats = draw(camera, frame_.options);
        const std::vector<std::uint8_t> values = canvas_.read();
        if (!goes_on()) throw Cancelled("drawing a picture was cancelled");
        writer_.write(path, pixels(values), settings);
        return stats;
    } catch (const OutOfMemory& error) {
        if (std::optional<FrameStats> stats = draw_smaller(camera, path, settings, error.what()))
            return *stats;
        throw;
    }
}

bool PictureOutput::draw(const Camera& camera, const std::filesystem::path& path) {
    ImageSettings settings = frame_.settings;
    settings.description += fmt::format(" {}", describe_camera(camera, frame_.origin));
    const FrameStats stats = frame_.tile_size != 0 ? draw_tiles(camera, path, settings)
                                                   : draw_whole(camera, path, settings);
    const Method method = frame_.options.method;
    const bool counts_runs = method != Method::spine && method != Method::opengl;
    return !counts_runs || stats.runs > 0 || frame_.options.style.hidden;
}

} // namespace lineatlas
