#include "drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <pugixml.hpp>

#include "io/atomic_file.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"

namespace lineatlas::bench {
namespace {

constexpr float png_scale = 2;
constexpr int channels = 3;

const char* font(bool bold) {
    return bold ? "DejaVuSans-Bold" : "DejaVuSans";
}

bool has_extension(const std::filesystem::path& path, std::string_view lower) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension == lower;
}

std::string hex(Rgb c) {
    return fmt::format("#{:02x}{:02x}{:02x}", c.x, c.y, c.z);
}

void add(pugi::xml_node& node, const char* name, const std::string& value) {
    node.append_attribute(name) = value.c_str();
}

void add(pugi::xml_node& node, const char* name, float value) {
    add(node, name, fmt::format("{:g}", std::round(value * 100) / 100));
}

std::string svg_text(const Drawing& drawing) {
    pugi::xml_document document;
    pugi::xml_node svg = document.append_child("svg");
    add(svg, "xmlns", "http://www.w3.org/2000/svg");
    add(svg, "width", drawing.size.x);
    add(svg, "height", drawing.size.y);
    add(svg, "viewBox", fmt::format("0 0 {:g} {:g}", drawing.size.x, drawing.size.y));
    add(svg, "font-family", "DejaVu Sans, Verdana, sans-serif");
    const auto add_box = [&](const Box& box) {
        pugi::xml_node rect = svg.append_child("rect");
        add(rect, "x", box.corner.x);
        add(rect, "y", box.corner.y);
        add(rect, "width", box.size.x);
        add(rect, "height", box.size.y);
        add(rect, "fill", hex(box.color));
    };
    add_box({glm::vec2{0}, drawing.size, Rgb{255}});
    for (const Box& box : drawing.boxes) add_box(box);
    for (const Curve& curve : drawing.curves) {
        std::string points;
        for (const glm::vec2 point : curve.points) {
            points += fmt::format("{}{:.2f},{:.2f}", points.empty() ? "" : " ", point.x, point.y);
        }
        pugi::xml_node line = svg.append_child("polyline");
        add(line, "points", points);
        add(line, "fill", std::string{"none"});
        add(line, "stroke", hex(curve.color));
        add(line, "stroke-width", curve.width);
        add(line, "stroke-linejoin", std::string{"round"});
    }
    for (const Label& label : drawing.labels) {
        pugi::xml_node text = svg.append_child("text");
        add(text, "x", label.at.x);
        add(text, "y", label.at.y);
        add(text, "font-size", label.size);
        add(text, "fill", hex(label.color));
        if (label.bold) add(text, "font-weight", "bold");
        if (label.anchor == Anchor::end) add(text, "text-anchor", "end");
        text.text() = label.text.c_str();
    }
    std::ostringstream out;
    document.save(out, " ");
    return out.str();
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

/// Antialiased; OpenImageIO only draws lines one pixel wide.
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

Image picture(const Drawing& drawing) {
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

} // namespace

void write_drawing(const std::filesystem::path& path, const Drawing& drawing) {
    if (!has_extension(path, ".svg")) return write_image(path, picture(drawing));
    const std::string text = svg_text(drawing);
    AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

void check_drawing_path(const std::filesystem::path& path) {
    if (has_extension(path, ".svg")) {
        const AtomicFile writable{path};
        return;
    }
    if (!has_extension(path, ".png")) {
        throw UsageError(
            fmt::format("--chart \"{}\": the file must end in .svg or .png", path.string()));
    }
    check_image_path(path);
    for (const bool bold : {false, true}) {
        if (!OIIO::ImageBufAlgo::text_size("1", 24, font(bold)).defined()) {
            throw DeviceError(fmt::format("the font {} is missing, install fonts-dejavu-core, or "
                                          "write the chart as .svg",
                                          font(bold)));
        }
    }
}

} // namespace lineatlas::bench
