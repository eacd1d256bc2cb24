#include "settings.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "colors.hpp"
#include "core/pens.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {
namespace {

constexpr float longest = 10'000; // pixels

struct Range {
    float least, most;
    bool above = false; ///< the least value itself is out
    bool contains(double value) const {
        return (above ? value > least : value >= least) && value <= most;
    }
};

std::string words(const Range& range, std::string_view unit = {}) {
    return fmt::format("{} {} {} {}{}{}", range.above ? "above" : "from", range.least,
                       range.above ? "and at most" : "to", range.most, unit.empty() ? "" : " ",
                       unit);
}

// Each maker takes `member`, a function from Style& or const Style& to the member.

template <class Member>
Setting number(std::string key, Member member, Range range, std::string_view unit,
               std::string help) {
    return {std::move(key),
            "a number " + words(range, unit),
            std::move(help),
            false,
            [member](const Style& style) -> SettingValue { return double{member(style)}; },
            [member, range](Style& style, const SettingValue& value) {
                const double* given = std::get_if<double>(&value);
                if (given == nullptr || !range.contains(*given)) return false;
                const auto narrowed = static_cast<float>(*given);
                if (!range.contains(narrowed)) return false; // 1e-60 is above 0 only as a double
                member(style) = narrowed;
                return true;
            }};
}

template <class Member>
Setting whole(std::string key, Member member, Range range, std::string help) {
    return {
        std::move(key),
        "a whole number " + words(range),
        std::move(help),
        false,
        [member](const Style& style) -> SettingValue { return static_cast<double>(member(style)); },
        [member, range](Style& style, const SettingValue& value) {
            const double* given = std::get_if<double>(&value);
            if (given == nullptr || !range.contains(*given) || *given != std::floor(*given)) {
                return false;
            }
            member(style) = static_cast<int>(*given);
            return true;
        }};
}

template <class Member>
Setting flag(std::string key, Member member, std::string help) {
    return {std::move(key),
            "true or false",
            std::move(help),
            true,
            [member](const Style& style) -> SettingValue { return member(style); },
            [member](Style& style, const SettingValue& value) {
                const bool* given = std::get_if<bool>(&value);
                if (given != nullptr) member(style) = *given;
                return given != nullptr;
            }};
}

/// `names` stand in the order of the enumerators.
template <class Member>
Setting choice(std::string key, Member member, std::vector<std::string> names, std::string help) {
    return {std::move(key),
            fmt::format("one of {}", fmt::join(names, ", ")),
            std::move(help),
            false,
            [member, names](const Style& style) -> SettingValue {
                return names.at(static_cast<std::size_t>(member(style)));
            },
            [member, names](Style& style, const SettingValue& value) {
                const std::string* given = std::get_if<std::string>(&value);
                if (given == nullptr) return false;
                const auto found = std::ranges::find(names, *given);
                if (found == names.end()) return false;
                using Enum = std::remove_reference_t<decltype(member(style))>;
                member(style) = static_cast<Enum>(found - names.begin());
                return true;
            },
            names};
}

template <class Member>
Setting color(std::string key, Member member, std::string help) {
    return {std::move(key),
            "\"#rrggbb\", a name such as \"navy\", or [r,g,b] from 0 to 1",
            std::move(help),
            false,
            [member](const Style& style) -> SettingValue {
                const glm::vec3 value = member(style);
                const std::string hex = hex_color(value);
                if (*parse_color(hex) == value) return hex;
                return std::vector<double>{value.x, value.y, value.z};
            },
            [member](Style& style, const SettingValue& value) {
                if (const auto* text = std::get_if<std::string>(&value)) {
                    const std::optional<glm::vec3> parsed = parse_color(*text);
                    if (parsed) member(style) = *parsed;
                    return parsed.has_value();
                }
                const auto* rgb = std::get_if<std::vector<double>>(&value);
                const auto in_range = [](double c) { return c >= 0 && c <= 1; };
                if (rgb == nullptr || rgb->size() != 3 || !std::ranges::all_of(*rgb, in_range)) {
                    return false;
                }
                member(style) = {(*rgb)[0], (*rgb)[1], (*rgb)[2]};
                return true;
            }};
}

template <class Member>
Setting profile(std::string key, Member member, Range range, std::string help) {
    constexpr std::size_t most = 16;
    return {std::move(key),
            "one number or a list of at most 16, each " + words(range),
            std::move(help),
            false,
            [member](const Style& style) -> SettingValue {
                const Profile& profile = member(style);
                if (profile.size() == 1) return double{profile[0]};
                return std::vector<double>(profile.begin(), profile.end());
            },
            [member, range](Style& style, const SettingValue& value) {
                std::vector<double> given;
                if (const auto* one = std::get_if<double>(&value)) given = {*one};
                if (const auto* list = std::get_if<std::vector<double>>(&value)) given = *list;
                const auto in_range = [&](double v) { return range.contains(v); };
                if (given.empty() || given.size() > most || !std::ranges::all_of(given, in_range)) {
                    return false;
                }
                member(style) = Profile(given.begin(), given.end());
                return true;
            }};
}

/// The name of a built-in mark or of an image file. `same`: a word for the empty name, or empty.
template <class Member>
Setting mark(std::string key, Member member, std::string same, std::string help) {
    std::vector<std::string> names;
    for (const PenName& pen : pen_names()) names.emplace_back(pen.name);
    if (!same.empty()) names.push_back(same);
    return {std::move(key),
            fmt::format("one of {}, or an image file", fmt::join(names, ", ")),
            std::move(help),
            false,
            [member, same](const Style& style) -> SettingValue {
                return member(style).empty() ? same : member(style);
            },
            [member, same, names](Style& style, const SettingValue& value) {
                const auto* given = std::get_if<std::string>(&value);
                if (given == nullptr) return false;
                if (!is_pen_file(*given) && std::ranges::find(names, *given) == names.end()) {
                    return false;
                }
                member(style) = *given == same ? "" : *given;
                return true;
            },
            names,
            true};
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
            [](Style& style, const SettingValue& value) {
                const auto* given = std::get_if<std::vector<double>>(&value);
                const auto good = [](double v) { return std::abs(v) <= 1e6; };
                if (given == nullptr || given->size() != 3 || !std::ranges::all_of(*given, good)) {
                    return false;
                }
                const glm::vec3 light{(*given)[0], (*given)[1], (*given)[2]};
                if (light == glm::vec3{0}) return false;
                style.fill.light = light;
                return true;
            }};
}

Setting density_priority() {
    return {"density-priority",
            fmt::format("{} numbers from 0 to 1: {}", line_kind_names.size(),
                        fmt::join(line_kind_names, ",")),
            "Which kinds of line stay longer where lines are dense",
            false,
            [](const Style& style) -> SettingValue {
                const auto& priority = style.density.priority;
                return std::vector<double>(priority.begin(), priority.end());
            },
            [](Style& style, const SettingValue& value) {
                const auto* given = std::get_if<std::vector<double>>(&value);
                auto& priority = style.density.priority;
                const auto in_range = [](double v) { return v >= 0 && v <= 1; };
                if (given == nullptr || given->size() != priority.size() ||
                    !std::ranges::all_of(*given, in_range)) {
                    return false;
                }
                std::ranges::transform(*given, priority.begin(),
                                       [](double v) { return static_cast<float>(v); });
                return true;
            }};
}

Setting focus() {
    return {"focus",
            "\"none\", X,Y in the window (0,0 lower left to 1,1) or X,Y,Z in the scene",
            "A point; lines farther from it take on the focus-... values",
            false,
            [](const Style& style) -> SettingValue {
                const Focus& focus = style.focus;
                if (!focus.on) return std::string{"none"};
                if (!focus.in_scene) return std::vector<double>{focus.point.x, focus.point.y};
                return std::vector<double>{focus.point.x, focus.point.y, focus.point.z};
            },
            [](Style& style, const SettingValue& value) {
                Focus& focus = style.focus;
                if (const auto* text = std::get_if<std::string>(&value)) {
                    if (*text == "none") focus.on = false;
                    return *text == "none";
                }
                const auto* given = std::get_if<std::vector<double>>(&value);
                const auto good = [](double v) { return std::abs(v) <= 1e30; };
                if (given == nullptr || given->size() < 2 || given->size() > 3 ||
                    !std::ranges::all_of(*given, good)) {
                    return false;
                }
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
    const Range length{0, longest};
    table.push_back(mark(
        name, [=](auto& s) -> auto& { return pen(s).mark; }, "", "Mark of " + whose));
    table.push_back(number(
        prefix + "width", [=](auto& s) -> auto& { return pen(s).width; }, {0, 1000, true}, "pixels",
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
    table.push_back(number(
        prefix + "cap-length", [=](auto& s) -> auto& { return pen(s).cap_length; }, length,
        "pixels", "Length of tapered and textured ends of " + whose));
    table.push_back(profile(
        prefix + "width-profile", [=](auto& s) -> auto& { return pen(s).width_profile; }, {0, 4},
        "Factors of the width of " + whose + " from start to end"));
    table.push_back(profile(
        prefix + "opacity-profile", [=](auto& s) -> auto& { return pen(s).opacity_profile; },
        {0, 1}, "Factors of the opacity of " + whose + " from start to end"));
}

std::vector<Setting> make_settings() {
    const Range length{0, longest};
    const Range share{0, 1};
    std::vector<Setting> t;
    add_pen(
        t, "pen", "", "the strokes", [](auto& s) -> auto& { return s.pen; });
    t.push_back(flag(
        "hidden", [](auto& s) -> auto& { return s.hidden; },
        "Draw hidden lines too, under the visible ones"));
    add_pen(
        t, "hidden-pen", "hidden-", "hidden lines", [](auto& s) -> auto& { return s.hidden_pen; });

    t.push_back(number(
        "fill-holes", [](auto& s) -> auto& { return s.filter.fill; }, length, "pixels",
        "Shorter holes in a line are closed"));
    t.push_back(number(
        "drop-runs", [](auto& s) -> auto& { return s.filter.drop; }, length, "pixels",
        "Shorter visible runs are left out"));
    t.push_back(number(
        "overshoot", [](auto& s) -> auto& { return s.filter.overshoot; }, length, "pixels",
        "Strokes are longer by this at both ends"));
    t.push_back(number(
        "overshoot-variation", [](auto& s) -> auto& { return s.filter.overshoot_variation; }, share,
        "", "Share of the overshoot that varies from path to path"));
    t.push_back(number(
        "undershoot", [](auto& s) -> auto& { return s.filter.undershoot; }, length, "pixels",
        "Strokes end this far before what hides them"));
    t.push_back(number(
        "halo", [](auto& s) -> auto& { return s.filter.halo; }, length, "pixels",
        "Gap in the farther of two crossing lines"));

    t.push_back(number(
        "density", [](auto& s) -> auto& { return s.density.limit; }, {0, 100},
        "pixels of line per pixel", "Most lines in a neighbourhood; 0 for any"));
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
        "Brightness of what is not lit"));
    t.push_back(whole(
        "toon-steps", [](auto& s) -> auto& { return s.fill.toon_steps; }, {2, 8},
        "Tones of toon filling"));

    t.push_back(color(
        "paper", [](auto& s) -> auto& { return s.paper.color; }, "Colour of the paper"));
    t.push_back(number(
        "paper-grain", [](auto& s) -> auto& { return s.paper.grain; }, share, "",
        "Strength of the paper's texture"));

    const Range extent{0, 1000};
    constexpr const char* of_window = "shares of the window's height or the model's diagonal";
    t.push_back(focus());
    t.push_back(number(
        "focus-radius", [](auto& s) -> auto& { return s.focus.radius; }, extent, of_window,
        "Nearer to the focus all is as it is without one"));
    t.push_back(number(
        "focus-falloff", [](auto& s) -> auto& { return s.focus.falloff; }, extent, of_window,
        "How far beyond the radius it takes to be far away"));
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

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::optional<double> number_from_text(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string toml_string(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            result += c;
        }
    }
    return result + '"';
}

} // namespace

std::span<const Setting> settings() {
    static const std::vector<Setting> table = make_settings();
    return table;
}

const Setting& find_setting(std::string_view key) {
    const auto found = std::ranges::find(settings(), key, &Setting::key);
    if (found != settings().end()) return *found;
    std::vector<std::string> keys;
    for (const Setting& setting : settings()) keys.push_back(setting.key);
    std::string near = suggestion(key, keys);
    if (near.empty()) near = "; `lineatlas styles --keys` lists what there is";
    throw UsageError(fmt::format("there is no setting \"{}\"{}", key, near));
}

void set_value(Style& style, const Setting& setting, const SettingValue& value,
               std::string_view called) {
    if (setting.set(style, value)) return;
    const auto* word = std::get_if<std::string>(&value);
    throw UsageError(fmt::format("{} must be {}, not {}{}", called, setting.values,
                                 value_to_toml(value),
                                 word != nullptr ? suggestion(*word, setting.names) : ""));
}

SettingValue value_from_text(std::string_view text) {
    if (text == "true" || text == "false") return text == "true";
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto value = number_from_text(text.substr(begin, end - begin));
        if (!value) return std::string{text};
        numbers.push_back(*value);
        begin = end + 1;
    }
    if (numbers.size() == 1) return numbers[0];
    return numbers;
}

std::string value_to_toml(const SettingValue& value) {
    // Members are floats: 0.1, not 0.10000000149011612.
    const auto number = [](double v) {
        const auto narrowed = static_cast<float>(v);
        return std::isinf(narrowed) ? fmt::format("{}", v) : fmt::format("{}", narrowed);
    };
    if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const double* one = std::get_if<double>(&value)) return number(*one);
    if (const auto* text = std::get_if<std::string>(&value)) return toml_string(*text);
    std::vector<std::string> numbers;
    for (const double v : std::get<std::vector<double>>(value)) numbers.push_back(number(v));
    return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string settings_table() {
    std::string table = "| key | what it does | default | must be |\n|---|---|---|---|\n";
    const Style defaults;
    for (const Setting& setting : settings()) {
        table += fmt::format("| `{}` | {} | `{}` | {} |\n", setting.key, setting.help,
                             value_to_toml(setting.get(defaults)), setting.values);
    }
    return table;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
    if (known.empty()) return {};
    const auto distance = [&](const std::string& name) { return edit_distance(word, name); };
    const std::string& nearest = *std::ranges::min_element(known, {}, distance);
    // Farther than that it is another word.
    if (distance(nearest) > std::max<std::size_t>(2, nearest.size() / 2)) return {};
    return fmt::format("; did you mean \"{}\"?", nearest);
}

} // namespace lineatlas
