#include "svg_groups.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "line_groups.hpp"
#include "path_data.hpp"
#include "paths.hpp"
#include "pen_stroke.hpp"
#include "svg_document.hpp"
#include "tags.hpp"

namespace lineatlas {
namespace {

constexpr int opacity_digits = 3;

const char* join_text(Join join) {
    switch (join) {
    case Join::round:
        return "round";
    case Join::bevel:
        return "bevel";
    case Join::mitre:
        break;
    }
    return "miter";
}

/// The value of `stroke-dasharray`.
std::string dashes_text(const PenStroke& stroke, double scale, int digits) {
    if (scale == 0) return "none";
    std::string text;
    for (const double each : stroke.dashes) {
        if (!text.empty()) text += ' ';
        text += number_text(scale * each, digits + 1);
    }
    return text;
}

void set_stroke(XmlElement& group, const Pen& pen, const Sheet& sheet) {
    const PenStroke stroke = pen_stroke(pen, sheet);
    const auto length = [&](double units) { return number_text(units, sheet.digits + 1); };
    group.set("fill", "none");
    group.set("stroke", color_text(stroke.color));
    group.set("stroke-width", length(stroke.width));
    if (stroke.opacity < 1) {
        group.set("stroke-opacity", number_text(stroke.opacity, opacity_digits));
    }
    group.set("stroke-linejoin", join_text(stroke.join));
    if (stroke.join == Join::mitre) {
        group.set("stroke-miterlimit", number_text(stroke.mitre_limit, opacity_digits));
    }
    group.set("stroke-linecap", stroke.round ? "round" : "butt");
    if (!stroke.dashes.empty()) group.set("stroke-dasharray", dashes_text(stroke, 1, sheet.digits));
}

XmlElement& add_group(XmlElement& parent, const LineGroup& lines, const Sheet& sheet,
                      const SvgPaths& how) {
    const std::string kind{lines.kind_name()};
    const std::string name = how.prefix + lines.name();
    XmlElement& group = parent.add("g");
    group.set("id", name);
    group.set("class",
              kind + (lines.thinned ? " thinned" : "") + (lines.visible ? " visible" : " hidden"));
    if (how.layers) {
        const std::string label = lines.visible ? name : how.prefix + kind + " (hidden)";
        mark_layer(group, !lines.visible && lines.thinned ? label + " (thinned)" : label);
    }
    if (lines.thinned) group.set("style", "display:none"); // as Inkscape hides a layer
    set_stroke(group, lines.pen, sheet);
    return group;
}

std::string fill_data(const VectorFill& fill, const Sheet& sheet) {
    constexpr int finer = 2; // digits than those of lines: borders are to stay apart
    std::string data;
    for (const Outline& ring : outlines_of(fill, sheet))
        data += path_data(ring, sheet.digits + finer, false);
    return data;
}

/// Pixels on a border have one of the colours beside it: a mixture with what is below would show
/// as a seam.
void write_fills(XmlElement& parent, const VectorDrawing& drawing, const Sheet& sheet,
                 const SvgPaths& how) {
    XmlElement& group = parent.add("g");
    group.set("id", how.prefix + fill_layer);
    group.set("class", fill_layer);
    if (how.layers) mark_layer(group, how.prefix + fill_layer);
    group.set("stroke", "none");
    group.set("fill-rule", "evenodd");
    group.set("shape-rendering", "crispEdges");
    for (const VectorFill& fill : drawing.fills) {
        const std::string data = fill_data(fill, sheet);
        if (data.empty()) continue;
        XmlElement& path = group.add("path");
        path.set("fill", color_text(fill.color));
        path.set("d", data);
        if (how.tags && !fill.object.empty()) add_text(path, "desc", "object " + fill.object);
    }
}

} // namespace

std::string color_text(glm::vec3 color) {
    const auto channel = [](float value) {
        return static_cast<int>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", channel(color.x), channel(color.y), channel(color.z));
}

void write_paths(XmlElement& parent, const VectorDrawing& drawing, const Sheet& sheet,
                 const SvgPaths& how) {
    if (!drawing.fills.empty()) write_fills(parent, drawing, sheet, how);
    for (const LineGroup& group : line_groups(drawing)) {
        XmlElement& node = add_group(parent, group, sheet, how);
        const PenStroke stroke = pen_stroke(group.pen, sheet);
        for (const VectorPath& path : group.paths) {
            const Outline outline = outline_of(path, sheet, how.arcs);
            const std::string data = path_data(outline, sheet.digits, how.relative);
            if (data.empty()) continue;
            XmlElement& element = node.add("path");
            element.set("d", data);
            const double scale = dash_scale(stroke, outline);
            if (scale != 1)
                element.set("stroke-dasharray", dashes_text(stroke, scale, sheet.digits));
            if (how.tags) add_text(element, "desc", tags_text(drawing, path));
        }
    }
}

} // namespace lineatlas
