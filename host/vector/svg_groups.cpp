#include "svg_groups.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "path_data.hpp"
#include "pen_stroke.hpp"

namespace lineatlas {
namespace {

constexpr int opacity_digits = 3;

void set(pugi::xml_node& node, const char* name, const std::string& value) {
    node.append_attribute(name) = value.c_str();
}

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

void set_stroke(pugi::xml_node& group, const Pen& pen, const Sheet& sheet) {
    const PenStroke stroke = pen_stroke(pen, sheet);
    const auto length = [&](double units) { return number_text(units, sheet.digits + 1); };
    set(group, "fill", "none");
    set(group, "stroke", color_text(stroke.color));
    set(group, "stroke-width", length(stroke.width));
    if (stroke.opacity < 1) {
        set(group, "stroke-opacity", number_text(stroke.opacity, opacity_digits));
    }
    set(group, "stroke-linejoin", join_text(stroke.join));
    if (stroke.join == Join::mitre) {
        set(group, "stroke-miterlimit", number_text(stroke.mitre_limit, opacity_digits));
    }
    set(group, "stroke-linecap", stroke.round ? "round" : "butt");
    if (stroke.dashes) {
        set(group, "stroke-dasharray",
            length(stroke.dashes->dash) + " " + length(stroke.dashes->gap));
    }
}

} // namespace

std::string color_text(glm::vec3 color) {
    const auto channel = [](float value) {
        return static_cast<int>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", channel(color.x), channel(color.y), channel(color.z));
}

pugi::xml_node add_group(pugi::xml_node& svg, const LineGroup& lines, const Sheet& sheet,
                         bool layers) {
    const std::string kind{lines.kind_name()};
    pugi::xml_node group = svg.append_child("g");
    set(group, "id", lines.name());
    set(group, "class", kind + (lines.visible ? " visible" : " hidden"));
    if (layers) {
        set(group, "inkscape:groupmode", "layer");
        set(group, "inkscape:label", lines.visible ? lines.name() : kind + " (hidden)");
    }
    set_stroke(group, lines.pen, sheet);
    return group;
}

} // namespace lineatlas
