#include "paint.hpp"

#include <array>
#include <cmath>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

constexpr float png_scale = 2;
constexpr int channels = 3;

const char* font(bool bold) {
    return bold ? "DejaVuSans-Bold" : "DejaVuSans";
}

std::array<float, channels> floats(Rgb c) {
    return {static_cast<float>(c.x) / 255, static_cast<float>(c.y) / 255,
            static_cast<float>(c.z) / 255};
}

float distance_to(glm::vec2 point, glm::vec2 a, glm::vec2 b) {
    const glm::vec2 way = b - a;
    const float squared = glm::dot(way, way);
    const float u = squared > 0 ? glm::clamp(glm::dot(point - a, way) / squared, 0.0F, 1.0F) : 0;
    return glm::distance(point, a + way * u);
}

/// Draws a curve with antialiasing. OpenImageIO's own lines are one pixel wide.
void add_curve(const Curve& curve, OIIO::ImageBuf& buffer) {
    const float reach = 0.5F * curve.width * png_scale;
    const auto color = floats(curve.color);
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
        const glm::vec2 a = curve.points[i] * png_scale;
        const glm::vec2 b = curve.points[i + 1] * png_scale;
        const glm::ivec2 low{glm::floor(glm::min(a, b) - reach - 1.0F)};
        const glm::ivec2 high{glm::ceil(glm::max(a, b) + reach + 1.0F)};
        for (OIIO::ImageBuf::Iterator<unsigned char, float> pixel(
                 buffer, OIIO::ROI{low.x, high.x, low.y, high.y});
             !pixel.done(); ++pixel) {
            if (!pixel.exists()) continue;
            const glm::vec2 centre = glm::vec2{pixel.x(), pixel.y()} + 0.5F;
            const float covered = glm::clamp(reach + 0.5F - distance_to(centre, a, b), 0.0F, 1.0F);
            for (int c = 0; c < channels; ++c)
                pixel[c] = glm::mix(float(pixel[c]), color[c], covered);
        }
    }
}

} // namespace

Image paint(const Drawing& drawing) {
    namespace oiio = OIIO;
    const glm::ivec2 size{glm::round(drawing.size * png_scale)};
    oiio::ImageBuf buffer{oiio::ImageSpec{size.x, size.y, channels, oiio::TypeDesc::UINT8}};
    oiio::ImageBufAlgo::fill(buffer, floats(Rgb{255}));
    for (const Box& box : drawing.boxes) {
        const glm::ivec2 first{glm::round(box.corner * png_scale)};
        glm::ivec2 end{glm::round((box.corner + box.size) * png_scale)};
        end = glm::max(end, first + 1); // the smallest value still shows
        oiio::ImageBufAlgo::fill(buffer, floats(box.color),
                                 oiio::ROI{first.x, end.x, first.y, end.y});
    }
    for (const Curve& curve : drawing.curves) add_curve(curve, buffer);
    for (const Label& label : drawing.labels) {
        const glm::ivec2 at{glm::round(label.at * png_scale)};
        const auto align = label.anchor == Anchor::end ? oiio::ImageBufAlgo::TextAlignX::Right
                                                       : oiio::ImageBufAlgo::TextAlignX::Left;
        oiio::ImageBufAlgo::render_text(buffer, at.x, at.y, label.text,
                                        static_cast<int>(std::lround(label.size * png_scale)),
                                        font(label.bold), floats(label.color), align);
    }
    if (buffer.has_error()) throw DeviceError("cannot draw the chart: " + buffer.geterror());
    Image image{.size = size, .channels = channels, .pixels = {}};
    image.pixels.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                        channels);
    buffer.get_pixels(buffer.roi(), oiio::TypeDesc::UINT8, image.pixels.data());
    return image;
}

void check_painting() {
    for (const bool bold : {false, true}) {
        if (!OIIO::ImageBufAlgo::text_size("1", 24, font(bold)).defined()) {
            throw DeviceError(fmt::format("the font {} is missing, install fonts-dejavu-core, or "
                                          "write the chart as .svg",
                                          font(bold)));
        }
    }
}

} // namespace lineatlas::bench
