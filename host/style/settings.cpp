#include "settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "frame_settings.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/style_files.hpp"
#include "pen_rules.hpp"
#include "setting_makers.hpp"

namespace lineatlas {
namespace {

using namespace makers;

constexpr Range up_to_longest{0, 10'000}; // pixels

bool is_direction(std::span<const double> v) {
    const auto good = [](double c) { return std::abs(c) <= 1e6; };
    return v.size() == 3 && std::ranges::all_of(v, good) &&
           glm::vec3{v[0], v[1], v[2]} != glm::vec3{0};
}

bool is_place(std::span<const double> v) {
    const auto good = [](double c) { return std::abs(c) <= 1e30; };
    return (v.size() == 2 || v.size() == 3) && std::ranges::all_of(v, good);
}

Setting light() {
    return {"light",
            "three numbers, not all 0: X,Y,Z",
            "Direction to the light; X to the right, Y up, Z to the eye",
            false,
            [](const Style& style) -> SettingValue {
                const glm::vec3 v = style.fill.light;
                return std::vector<double>{v.x, v.y, v.z};
            },
            [](const Style& style) {
                const glm::dvec3 v = style.fill.light;
                return is_direction(std::array{v.x, v.y, v.z});
            },
            [](Style& style, const SettingValue& value) {
                const auto* given = std::get_if<std::vector<double>>(&value);
                if (given == nullptr || !is_direction(*given)) return false;
                style.fill.light = {(*given)[0], (*given)[1], (*given)[2]};
                return true;
            }};
}

Setting density_priority() {
    return {
        "density-priority",
        fmt::format("{} numbers from 0 to 1: {}", line_kind_names.size(),
                    fmt::join(line_kind_names, ",")),
        "Which kinds of line stay longer where lines are dense",
        false,
        [](const Style& style) -> SettingValue {
            const auto& priority = style.density.priority;
            return std::vector<double>(priority.begin(), priority.end());
        },
        [](const Style& style) { return std::ranges::all_of(style.density.priority, is_share); },
        [](Style& style, const SettingValue& value) {
            const auto* given = std::get_if<std::vector<double>>(&value);
            auto& priority = style.density.priority;
            if (given == nullptr || given->size() != priority.size() ||
                !std::ranges::all_of(*given, is_share)) {
                return false;
            }
            std::ranges::transform(*given, priority.begin(),
                                   [](double v) { return static_cast<float>(v); });
            return true;
        }};
}

/// A setting whose member is a LineKindMask.
Setting more_lines() {
    constexpr std::string_view none = "none";
    return {"more-lines",
            fmt::format("none, or one or more, separated by commas, of {}",
                        fmt::join(line_kind_names, ", ")),
            "Kinds of line to draw besides the usual ones",
            false,
            [=](const Style& style) -> SettingValue {
                return style.more_lines == 0 ? std::string{none}
                                             : line_kinds_to_text(style.more_lines);
            },
            [](const Style& style) { return (style.more_lines & ~all_line_kinds) == 0; },
            [=](Style& style, const SettingValue& value) {
                const auto* given = std::get_if<std::string>(&value);
                if (given == nullptr) return false;
                const auto kinds =
                    *given == none ? std::optional{LineKindMask{0}} : line_kinds_from(*given);
                if (kinds) style.more_lines = *kinds;
                return kinds.has_value();
            }};
}

Setting focus() {
    return {"focus",
            "\"none\", X,Y in the window (0,0 lower left to 1,1) or X,Y,Z of the model",
            "A point; lines farther from it take on the focus-... values",
            false,
            [](const Style& style) -> SettingValue {
                const Focus& focus = style.focus;
                if (!focus.on) return std::string{"none"};
                if (!focus.in_scene) return std::vector<double>{focus.point.x, focus.point.y};
                return std::vector<double>{focus.point.x, focus.point.y, focus.point.z};
            },
            [](const Style& style) {
                const glm::dvec3& point = style.focus.point;
                return is_place(std::array{point.x, point.y, point.z});
            },
            [](Style& style, const SettingValue& value) {
                Focus& focus = style.focus;
                if (const auto* text = std::get_if<std::string>(&value)) {
                    if (*text == "none") focus.on = false;
                    return *text == "none";
                }
                const auto* given = std::get_if<std::vector<double>>(&value);
                if (given == nullptr || !is_place(*given)) return false;
                focus.on = true;
                focus.in_scene = given->size() == 3;
                focus.point = {(*given)[0], (*given)[1], focus.in_scene ? (*given)[2] : 0.0};
                return true;
            }};
}

/// The settings of a pen; `pen` is a function from Style to it.
template <class Pen>
void add_pen(std::vector<Setting>& table, const std::string& name, const std::string& prefix,
             const std::string& whose, Pen pen) {
    table.push_back(mark(
        name, [=](auto& s) -> auto& { return pen(s).mark; }, "", "Mark of " + whose));
    table.push_back(length(
        prefix + "width", [=](auto& s) -> auto& { return pen(s).width; }, {0, 1000, true},
        "Width of " + whose));
    table.push_back(color(
        prefix + "color", [=](auto& s) -> auto& { return pen(s).color; }, "Colour of " + whose));
    table.push_back(number(
        prefix + "opacity", [=](auto& s) -> auto& { return pen(s).opacity; }, {0, 1}, "",
        "Opacity of " + whose));
    table.push_back(choice(
        prefix + "join", [=](auto& s) -> auto& { return pen(s).join; }, {"mitre", "round", "bevel"},
        "Joins of " + whose));
    table.push_back(number(
        prefix + "mitre-limit", [=](auto& s) -> auto& { return pen(s).mitre_limit; }, {1, 100},
        "stroke widths", "Longer mitres of " + whose + " are bevelled"));
    const std::vector<std::string> caps{"butt", "round", "taper", "texture"};
    table.push_back(choice(
        prefix + "cap", [=](auto& s) -> auto& { return pen(s).cap; }, caps,
        "Ends of " + whose + " where visibility ends"));
    table.push_back(choice(
        prefix + "path-cap", [=](auto& s) -> auto& { return pen(s).path_cap; }, caps,
        "Ends of " + whose + " where the line itself ends"));
    table.push_back(length(
        prefix + "cap-length", [=](auto& s) -> auto& { return pen(s).cap_length; }, up_to_longest,
        "Length of tapered and textured ends of " + whose));
    table.push_back(profile(
        prefix + "width-profile", [=](auto& s) -> auto& { return pen(s).width_profile; }, {0, 4},
        "Factors of the width of " + whose + " from start to end"));
    table.push_back(profile(
        prefix + "opacity-profile", [=](auto& s) -> auto& { return pen(s).opacity_profile; },
        {0, 1}, "Factors of the opacity of " + whose + " from start to end"));
}

std::vector<Setting> make_settings() {
    const Range share{0, 1};
    std::vector<Setting> t;
    add_pen(
        t, "pen", "", "the strokes", [](auto& s) -> auto& { return s.pen; });
    t.push_back(flag(
        "hidden", [](auto& s) -> auto& { return s.hidden; },
        "Draw hidden lines too, under the visible ones"));
    add_pen(
        t, "hidden-pen", "hidden-", "hidden lines", [](auto& s) -> auto& { return s.hidden_pen; });

    t.push_back(length(
        "fill-holes", [](auto& s) -> auto& { return s.filter.fill_holes; }, up_to_longest,
        "Shorter holes in a line are closed"));
    t.push_back(length(
        "drop-runs", [](auto& s) -> auto& { return s.filter.drop_runs; }, up_to_longest,
        "Shorter visible runs are left out"));
    t.push_back(length(
        "overshoot", [](auto& s) -> auto& { return s.filter.overshoot; }, up_to_longest,
        "Strokes are longer by this at both ends"));
    t.push_back(number(
        "overshoot-variation", [](auto& s) -> auto& { return s.filter.overshoot_variation; }, share,
        "", "Share of the overshoot that varies from path to path"));
    t.push_back(length(
        "undershoot", [](auto& s) -> auto& { return s.filter.undershoot; }, up_to_longest,
        "Strokes end this far before the face that hides them"));
    t.push_back(length(
        "halo", [](auto& s) -> auto& { return s.filter.halo; }, up_to_longest,
        "Gap in the farther of two crossing lines"));

    t.push_back(more_lines());
    t.push_back(length(
        "centre-overhang", [](auto& s) -> auto& { return s.centre_overhang; }, up_to_longest,
        "Centre lines are longer by this at both ends"));

    t.push_back(number(
        "density", [](auto& s) -> auto& { return s.density.limit; }, {0, 100},
        "pixels of line per pixel", "Largest density of lines; 0: no limit"));
    t.push_back(number(
        "hidden-density", [](auto& s) -> auto& { return s.hidden_density; }, {0, 100},
        "pixels of line per pixel", "Largest density of hidden lines; 0: no limit"));
    t.push_back(density_priority());

    t.push_back(choice(
        "fill", [](auto& s) -> auto& { return s.fill.mode; }, {"none", "flat", "lambert", "toon"},
        "Colour under the lines"));
    t.push_back(color(
        "fill-color", [](auto& s) -> auto& { return s.fill.color; },
        "Colour of faces whose material has none"));
    t.push_back(light());
    t.push_back(number(
        "ambient", [](auto& s) -> auto& { return s.fill.ambient; }, share, "",
        "Brightness of unlit faces"));
    t.push_back(whole(
        "toon-steps", [](auto& s) -> auto& { return s.fill.toon_steps; }, {2, 8},
        "Tones of toon filling"));

    t.push_back(color(
        "paper", [](auto& s) -> auto& { return s.paper.color; }, "Colour of the paper"));
    t.push_back(number(
        "paper-grain", [](auto& s) -> auto& { return s.paper.grain; }, share, "",
        "Strength of the paper's texture"));

    t.push_back(number(
        "made-for", [](auto& s) -> auto& { return s.made_for; },
        {.least = 1, .most = 65536, .or_zero = true}, "pixels",
        "Shorter side of the picture that lengths are meant for; they grow with a larger picture; "
        "0: they never grow"));

    const Range extent{0, 1000};
    constexpr const char* of_window = "shares of the window's height or the model's diagonal";
    t.push_back(focus());
    t.push_back(number(
        "focus-radius", [](auto& s) -> auto& { return s.focus.radius; }, extent, of_window,
        "Distance from the focus within which lines look as without a focus"));
    t.push_back(number(
        "focus-falloff", [](auto& s) -> auto& { return s.focus.falloff; }, extent, of_window,
        "Distance beyond the radius over which lines change to the focus-... values"));
    t.push_back(number(
        "focus-width", [](auto& s) -> auto& { return s.focus.width; }, {0, 100}, "",
        "Factor of the width far away"));
    t.push_back(number(
        "focus-opacity", [](auto& s) -> auto& { return s.focus.opacity; }, share, "",
        "Factor of the opacity far away"));
    t.push_back(number(
        "focus-hidden-opacity", [](auto& s) -> auto& { return s.focus.hidden_opacity; }, share, "",
        "Factor of the hidden lines' opacity far away"));
    t.push_back(number(
        "focus-density", [](auto& s) -> auto& { return s.focus.density; }, {0, 100}, "",
        "Factor of the density far away"));
    t.push_back(mark(
        "focus-pen", [](auto& s) -> auto& { return s.focus.mark; }, "same",
        "Mark of the strokes far away"));
    return t;
}

} // namespace

std::span<const Setting> settings() {
    static const std::vector<Setting> table = make_settings();
    return table;
}

const Setting& find_setting(std::string_view key) {
    return find_setting(settings(), key, "`lineatlas styles --keys`");
}

void check_style(const Style& style) {
    for (const Setting& setting : settings()) check_member(style, setting, "style: ");
    for (std::size_t i = 0; i < style.pens.size(); ++i) check_rule(style, i);
}

void apply_setting(Style& style, std::string_view key_is_value) {
    const std::size_t equals = key_is_value.find('=');
    if (equals == std::string_view::npos) {
        throw UsageError(fmt::format("\"{}\" is no setting; write it as key=value", key_is_value));
    }
    const Setting& setting = find_setting(key_is_value.substr(0, equals));
    set_value(style, setting, value_from_text(key_is_value.substr(equals + 1)), setting.key);
}

} // namespace lineatlas
