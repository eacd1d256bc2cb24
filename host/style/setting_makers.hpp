#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "base/numbers.hpp"
#include "base/units.hpp"
#include "colors.hpp"
#include "core/pens.hpp"
#include "lineatlas/style.hpp"
#include "setting.hpp"

// A maker of settings for each type of member. Members are those of a style unless a maker says
// otherwise.
namespace lineatlas::makers {

struct Range {
    float least, most;
    bool above = false;   ///< the least value itself is not allowed
    bool or_zero = false; ///< 0 is allowed too
    bool contains(double value) const {
        if (or_zero && value == 0) return true;
        return (above ? value > least : value >= least) && value <= most;
    }
};

inline std::string words(const Range& range, std::string_view unit = {}) {
    return fmt::format("{} {} {} {}{}{}{}", range.above ? "above" : "from", range.least,
                       range.above ? "and at most" : "to", range.most, unit.empty() ? "" : " ",
                       unit, range.or_zero ? ", or 0" : "");
}

// Each maker takes `member`, a function from Struct& or const Struct& to the member.

template <class Struct = Style, class Member>
SettingOf<Struct> number(std::string key, Member member, Range range, std::string_view unit,
                         std::string help) {
    return {std::move(key),
            "a number " + words(range, unit),
            std::move(help),
            false,
            [member](const Struct& object) -> SettingValue { return double{member(object)}; },
            [member, range](const Struct& object) { return range.contains(member(object)); },
            [member, range](Struct& object, const SettingValue& value) {
                const double* given = std::get_if<double>(&value);
                if (given == nullptr || !range.contains(*given)) return false;
                const auto narrowed = static_cast<float>(*given);
                if (!range.contains(narrowed)) return false; // 1e-60 is above 0 only as a double
                member(object) = narrowed;
                return true;
            }};
}

/// Pixels from a number, or from a length on paper with 96 pixels to an inch.
inline std::optional<double> pixels_of(const SettingValue& value) {
    if (const double* pixels = std::get_if<double>(&value)) return *pixels;
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) return std::nullopt;
    std::string_view rest = *text;
    const std::optional<double> number = take_number(rest);
    const NamedUnit* unit = unit_named(rest);
    if (!number || unit == nullptr) return std::nullopt;
    return *number * unit->pixels;
}

/// A length of strokes.
template <class Struct = Style, class Member>
SettingOf<Struct> length(std::string key, Member member, Range range, std::string help) {
    SettingOf<Struct> made =
        number<Struct>(std::move(key), member, range, "pixels", std::move(help));
    made.values += ", or a length on paper as \"0.5mm\"";
    made.set = [set = std::move(made.set)](Struct& object, const SettingValue& value) {
        const std::optional<double> pixels = pixels_of(value);
        return pixels && set(object, *pixels);
    };
    return made;
}

template <class Struct = Style, class Member>
SettingOf<Struct> whole(std::string key, Member member, Range range, std::string help) {
    return {std::move(key),
            "a whole number " + words(range),
            std::move(help),
            false,
            [member](const Struct& object) -> SettingValue {
                return static_cast<double>(member(object));
            },
            [member, range](const Struct& object) { return range.contains(member(object)); },
            [member, range](Struct& object, const SettingValue& value) {
                const double* given = std::get_if<double>(&value);
                if (given == nullptr || !range.contains(*given) || *given != std::floor(*given)) {
                    return false;
                }
                member(object) = static_cast<int>(*given);
                return true;
            }};
}

template <class Struct = Style, class Member>
SettingOf<Struct> flag(std::string key, Member member, std::string help) {
    return {std::move(key),
            "true or false",
            std::move(help),
            true,
            [member](const Struct& object) -> SettingValue { return member(object); },
            [](const Struct&) { return true; },
            [member](Struct& object, const SettingValue& value) {
                const bool* given = std::get_if<bool>(&value);
                if (given != nullptr) member(object) = *given;
                return given != nullptr;
            }};
}

/// `names` stand in the order of the enumerators.
template <class Struct = Style, class Member>
SettingOf<Struct> choice(std::string key, Member member, std::vector<std::string> names,
                         std::string help) {
    return {std::move(key),
            fmt::format("one of {}", fmt::join(names, ", ")),
            std::move(help),
            false,
            [member, names](const Struct& object) -> SettingValue {
                const auto number = static_cast<std::size_t>(member(object));
                if (number < names.size()) return names[number];
                return static_cast<double>(member(object)); // the value is no enumerator
            },
            [member, count = names.size()](const Struct& object) {
                return static_cast<std::size_t>(member(object)) < count;
            },
            [member, names](Struct& object, const SettingValue& value) {
                const std::string* given = std::get_if<std::string>(&value);
                if (given == nullptr) return false;
                const auto found = std::ranges::find(names, *given);
                if (found == names.end()) return false;
                using Enum = std::remove_reference_t<decltype(member(object))>;
                member(object) = static_cast<Enum>(found - names.begin());
                return true;
            },
            names};
}

inline bool is_share(double value) {
    return value >= 0 && value <= 1;
}

template <class Struct = Style, class Member>
SettingOf<Struct> color(std::string key, Member member, std::string help) {
    return {std::move(key),
            "\"#rrggbb\", a name such as \"navy\", or [r,g,b] from 0 to 1",
            std::move(help),
            false,
            [member](const Struct& object) -> SettingValue {
                const glm::vec3 value = member(object);
                const std::string hex = hex_color(value);
                if (*parse_color(hex) == value) return hex;
                return std::vector<double>{value.x, value.y, value.z};
            },
            [member](const Struct& object) {
                const glm::vec3 value = member(object);
                return is_share(value.x) && is_share(value.y) && is_share(value.z);
            },
            [member](Struct& object, const SettingValue& value) {
                if (const auto* text = std::get_if<std::string>(&value)) {
                    const std::optional<glm::vec3> parsed = parse_color(*text);
                    if (parsed) member(object) = *parsed;
                    return parsed.has_value();
                }
                const auto* rgb = std::get_if<std::vector<double>>(&value);
                if (rgb == nullptr || rgb->size() != 3 || !std::ranges::all_of(*rgb, is_share)) {
                    return false;
                }
                member(object) = {(*rgb)[0], (*rgb)[1], (*rgb)[2]};
                return true;
            }};
}

template <class Struct = Style, class Member>
SettingOf<Struct> profile(std::string key, Member member, Range range, std::string help) {
    constexpr std::size_t most = 16;
    return {std::move(key),
            "one number or a list of at most 16, each " + words(range),
            std::move(help),
            false,
            [member](const Struct& object) -> SettingValue {
                const Profile& profile = member(object);
                if (profile.size() == 1) return double{profile[0]};
                return std::vector<double>(profile.begin(), profile.end());
            },
            [member, range](const Struct& object) {
                const Profile& profile = member(object);
                const auto in_range = [&](float v) { return range.contains(v); };
                return !profile.empty() && profile.size() <= most &&
                       std::ranges::all_of(profile, in_range);
            },
            [member, range](Struct& object, const SettingValue& value) {
                std::vector<double> given;
                if (const auto* one = std::get_if<double>(&value)) given = {*one};
                if (const auto* list = std::get_if<std::vector<double>>(&value)) given = *list;
                const auto in_range = [&](double v) { return range.contains(v); };
                if (given.empty() || given.size() > most || !std::ranges::all_of(given, in_range)) {
                    return false;
                }
                member(object) = Profile(given.begin(), given.end());
                return true;
            }};
}

/// The name of a built-in mark or of an image file. `same`: a word for the empty name, or empty.
template <class Struct = Style, class Member>
SettingOf<Struct> mark(std::string key, Member member, std::string same, std::string help) {
    std::vector<std::string> names;
    for (const PenName& pen : pen_names()) names.emplace_back(pen.name);
    if (!same.empty()) names.push_back(same);
    const auto is_known = [names](const std::string& mark) {
        return is_pen_file(mark) || std::ranges::find(names, mark) != names.end();
    };
    return {std::move(key),
            fmt::format("one of {}, or an image file", fmt::join(names, ", ")),
            std::move(help),
            false,
            [member, same](const Struct& object) -> SettingValue {
                return member(object).empty() ? same : member(object);
            },
            [member, same, is_known](const Struct& object) {
                const std::string& mark = member(object);
                return mark.empty() ? !same.empty() : mark != same && is_known(mark);
            },
            [member, same, is_known](Struct& object, const SettingValue& value) {
                const auto* given = std::get_if<std::string>(&value);
                if (given == nullptr || !is_known(*given)) return false;
                member(object) = *given == same ? "" : *given;
                return true;
            },
            names,
            true};
}

} // namespace lineatlas::makers
