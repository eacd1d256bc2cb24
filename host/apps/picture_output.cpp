#include "picture_output.hpp"

#include <utility>

#include "description.hpp"

namespace lineatlas::apps {
namespace {

/// Colours divided by a small alpha need more than the 8 bits that are left in the end.
int canvas_bits(const PictureFrame& frame) {
    return frame.settings.bits > 8 || frame.transparent ? 16 : 8;
}

} // namespace

PictureOutput::PictureOutput(PictureFrame frame, Renderer& renderer, ImageWriter& writer)
    : frame_(std::move(frame)), renderer_(renderer), writer_(writer),
      canvas_(frame_.size, canvas_bits(frame_)) {}

FrameStats PictureOutput::draw(const Camera& camera, const FrameOptions& options) {
    canvas_.clear(frame_.transparent ? glm::vec4{0} : glm::vec4{options.style.paper.color, 1});
    return renderer_.draw(camera, options, canvas_.framebuffer());
}

void PictureOutput::draw(const Camera& camera, const std::filesystem::path& path) {
    draw(camera, frame_.options);
    ImageSettings settings = frame_.settings;
    settings.description += " " + describe_camera(camera);
    const std::vector<std::uint8_t> pixels = canvas_.read();
    writer_.write(path,
                  {.size = frame_.size,
                   .channels = 4,
                   .bits = canvas_.bits(),
                   .premultiplied = true,
                   .values = std::as_bytes(std::span{pixels})},
                  settings);
}

} // namespace lineatlas::apps
