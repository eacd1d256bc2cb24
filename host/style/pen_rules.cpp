#include "pen_rules.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "core/line_pens.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"
#include "setting_makers.hpp"
#include "settings.hpp"

namespace lineatlas {
namespace {

constexpr std::string_view factor_key = "width-factor";
constexpr makers::Range factor_range{0.01F, 100};

/// Calls `each(key, member of PenRule, member of Pen)` for all members of a pen that a rule can
/// change.
template <class Each>
void for_each_member(Each each) {
    each("pen", &PenRule::mark, &Pen::mark);
    each("width", &PenRule::width, &Pen::width);
    each("color", &PenRule::color, &Pen::color);
    each("opacity", &PenRule::opacity, &Pen::opacity);
    each("join", &PenRule::join, &Pen::join);
    each("mitre-limit", &PenRule::mitre_limit, &Pen::mitre_limit);
    each("cap", &PenRule::cap, &Pen::cap);
    each("path-cap", &PenRule::path_cap, &Pen::path_cap);
    each("cap-length", &PenRule::cap_length, &Pen::cap_length);
    each("width-profile", &PenRule::width_profile, &Pen::width_profile);
    each("opacity-profile", &PenRule::opacity_profile, &Pen::opacity_profile);
}

std::vector<std::string> known_keys() {
    std::vector<std::string> keys{"match"};
    for_each_member([&](const char* key, auto, auto) { keys.emplace_back(key); });
    keys.emplace_back(factor_key);
    return keys;
}

UsageError unknown_key(std::string_view key) {
    std::string advice = suggestion(key, known_keys());
    if (advice.empty()) advice = fmt::format("; there is {}", fmt::join(known_keys(), ", "));
    return UsageError{fmt::format("pens: a rule has no \"{}\"{}", key, advice)};
}

std::vector<std::string> known_kinds() {
    std::vector<std::string> kinds{line_kind_names.begin(), line_kind_names.end()};
    kinds.emplace_back(outline_name);
    return kinds;
}

bool is_hidden_outline(const PenMatch& match) {
    return match.hidden && std::ranges::find(match.kinds, outline_name) != match.kinds.end();
}

/// The settings of the style's own pen that rules change.
const std::vector<const Setting*>& settings_of_pen() {
    static const std::vector<const Setting*> of_pen = [] {
        std::vector<const Setting*> found;
        for_each_member([&](const char* key, auto, auto) { found.push_back(&find_setting(key)); });
        return found;
    }();
    return of_pen;
}

const std::vector<std::string>& checked_kinds(const std::vector<std::string>& given) {
    const std::vector<std::string> kinds = known_kinds();
    for (const std::string& kind : given) {
        if (std::ranges::find(kinds, kind) != kinds.end()) continue;
        std::string advice = suggestion(kind, kinds);
        if (advice.empty()) advice = fmt::format("; there is {}", fmt::join(kinds, ", "));
        throw UsageError(fmt::format("pens: there is no kind \"{}\"{}", kind, advice));
    }
    return given;
}

void set_factor(PenRule& rule, const SettingValue& value) {
    const double* given = std::get_if<double>(&value);
    if (given == nullptr || !factor_range.contains(*given))
        throw wrong_value(factor_key, "a number " + makers::words(factor_range), {}, value);
    rule.width_factor = static_cast<float>(*given);
}

std::string match_to_toml(const PenMatch& match) {
    std::vector<std::string> parts;
    const auto text = [](const std::string& value) { return value_to_toml(SettingValue{value}); };
    if (!match.kinds.empty()) {
        std::vector<std::string> kinds;
        for (const std::string& kind : match.kinds) kinds.push_back(text(kind));
        parts.push_back(kinds.size() == 1 ? "kind = " + kinds.front()
                                          : fmt::format("kind = [{}]", fmt::join(kinds, ", ")));
    }
    if (!match.object.empty()) parts.push_back("object = " + text(match.object));
    if (!match.material.empty()) parts.push_back("material = " + text(match.material));
    if (match.hidden) parts.emplace_back("hidden = true");
    return parts.empty() ? "{}" : fmt::format("{{ {} }}", fmt::join(parts, ", "));
}

} // namespace

const Setting& pen_setting(std::string_view key) {
    bool known = false;
    for_each_member([&](std::string_view own, auto, auto) { known = known || own == key; });
    if (!known) throw unknown_key(key);
    return find_setting(key);
}

void set_pen_key(PenRule& rule, std::string_view key, const SettingValue& value) {
    if (key == factor_key) return set_factor(rule, value);
    Style style;
    set_value(style, pen_setting(key), value, key);
    for_each_member([&](std::string_view own, auto of_rule, auto of_pen) {
        if (own == key) rule.*of_rule = style.pen.*of_pen;
    });
}

void set_match_key(PenMatch& match, std::string_view key,
                   const std::variant<bool, std::vector<std::string>>& value) {
    constexpr std::array keys{"kind", "object", "material", "hidden"};
    if (std::ranges::find(keys, key) == keys.end())
        throw UsageError(
            fmt::format("pens: match knows no \"{}\"; there is {}", key, fmt::join(keys, ", ")));
    const bool* flag = std::get_if<bool>(&value);
    const auto* values = std::get_if<std::vector<std::string>>(&value);
    if (key == "hidden") {
        if (flag == nullptr) throw UsageError("pens: hidden must be true or false");
        match.hidden = *flag;
    } else if (key == "kind") {
        if (values == nullptr) throw UsageError("pens: kind must be a text");
        match.kinds = checked_kinds(*values);
    } else {
        if (values == nullptr || values->size() != 1 || values->front().empty())
            throw UsageError(fmt::format("pens: {} must be a name, with * and ? if need be", key));
        (key == "object" ? match.object : match.material) = values->front();
    }
    if (is_hidden_outline(match)) throw UsageError("pens: hidden lines have no outline");
}

void check_rule(const Style& style, std::size_t number) {
    const PenRule& rule = style.pens[number];
    const std::string of = fmt::format("style: rule {} of pens: ", number + 1);
    checked_kinds(rule.match.kinds);
    if (is_hidden_outline(rule.match)) throw UsageError(of + "hidden lines have no outline");
    if (rule.width_factor && !factor_range.contains(*rule.width_factor))
        throw wrong_value(of + std::string{factor_key}, "a number " + makers::words(factor_range),
                          {}, double{*rule.width_factor});
    const Pen& own = rule.match.hidden ? style.hidden_pen : style.pen;
    const Style with{.pen = with_rule(own, rule, own)};
    for (const Setting* setting : settings_of_pen()) check_member(with, *setting, of);
}

std::vector<std::pair<std::string, SettingValue>> pen_values(const PenRule& rule) {
    std::vector<std::pair<std::string, SettingValue>> values;
    for_each_member([&](const char* key, auto of_rule, auto of_pen) {
        if (!(rule.*of_rule)) return;
        Style style;
        style.pen.*of_pen = *(rule.*of_rule);
        values.emplace_back(key, find_setting(key).get(style));
    });
    if (rule.width_factor) values.emplace_back(factor_key, double{*rule.width_factor});
    return values;
}

std::string pens_to_toml(const std::vector<PenRule>& rules) {
    std::string text;
    for (const PenRule& rule : rules) {
        text += "\n[[pens]]\nmatch = " + match_to_toml(rule.match) + "\n";
        for (const auto& [key, value] : pen_values(rule))
            text += fmt::format("{} = {}\n", key, value_to_toml(value));
    }
    return text;
}

} // namespace lineatlas
