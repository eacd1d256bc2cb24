#include "drawing.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/core.h>
#include <pugixml.hpp>

#include "io/atomic_file.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "paint.hpp"

namespace lineatlas::bench {
namespace {

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

} // namespace

void write_drawing(const std::filesystem::path& path, const Drawing& drawing) {
    if (!has_extension(path, ".svg")) return write_image(path, paint(drawing));
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
    check_painting();
}

} // namespace lineatlas::bench
