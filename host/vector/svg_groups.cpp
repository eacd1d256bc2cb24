#include "svg_groups.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "core/pens.hpp"
#include "path_data.hpp"

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

/// SVG knows one cap for both ends and for dashes; tapers and worn ends are cut square.
const char* cap_text(const Pen& pen, const std::optional<DashLengths>& dashes) {
    if (dashes) return dashes->round ? "round" : "butt";
    return pen.path_cap == Cap::round ? "round" : "butt";
}

void set_stroke(pugi::xml_node& group, const Pen& pen, const Sheet& sheet) {
    const auto length = [&](double pixels) {
        return number_text(pixels * sheet.scale, sheet.digits + 1);
    };
    set(group, "fill", "none");
    set(group, "stroke", color_text(pen.color));
    set(group, "stroke-width", length(static_cast<double>(pen.width)));
    if (pen.opacity < 1) {
        set(group, "stroke-opacity", number_text(static_cast<double>(pen.opacity), opacity_digits));
    }
    set(group, "stroke-linejoin", join_text(pen.join));
    if (pen.join == Join::mitre) {
        set(group, "stroke-miterlimit",
            number_text(static_cast<double>(pen.mitre_limit), opacity_digits));
    }
    const std::optional<DashLengths> dashes = dash_lengths(pen.mark, pen.width);
    set(group, "stroke-linecap", cap_text(pen, dashes));
    if (dashes) {
        set(group, "stroke-dasharray",
            length(static_cast<double>(dashes->dash)) + " " +
                length(static_cast<double>(dashes->gap)));
    }
}

} // namespace

std::string color_text(glm::vec3 color) {
    const auto channel = [](float value) {
        return static_cast<int>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", channel(color.x), channel(color.y), channel(color.z));
}

pugi::xml_node add_group(pugi::xml_node& svg, const Style& style, LineKind kind, bool visible,
                         const Sheet& sheet, bool layers) {
    const std::string name{line_kind_names[static_cast<std::size_t>(kind)]};
    pugi::xml_node group = svg.append_child("g");
    set(group, "id", visible ? name : name + "-hidden");
    set(group, "class", name + (visible ? " visible" : " hidden"));
    if (layers) {
        set(group, "inkscape:groupmode", "layer");
        set(group, "inkscape:label", visible ? name : name + " (hidden)");
    }
    set_stroke(group, visible ? style.pen : style.hidden_pen, sheet);
    return group;
}

} // namespace lineatlas
