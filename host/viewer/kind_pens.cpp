#include "kind_pens.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/name_pattern.hpp"
#include "core/line_pens.hpp"
#include "parts.hpp"

namespace lineatlas::viewer {
namespace {

/// Whether a rule is for kinds of visible lines alone, as the sliders are.
bool is_for_kinds_alone(const PenRule& rule) {
    return rule.match.object.empty() && rule.match.material.empty() && !rule.match.hidden;
}

bool names(const PenRule& rule, std::string_view kind) {
    return rule.match.kinds.empty() ||
           std::ranges::find(rule.match.kinds, kind) != rule.match.kinds.end();
}

bool is_of(const PenRule& rule, std::string_view kind) {
    return is_for_kinds_alone(rule) && rule.match.kinds.size() == 1 &&
           rule.match.kinds.front() == kind;
}

/// Whether a rule counts more than one for a kind.
bool is_narrower(const PenRule& rule, std::string_view kind) {
    if (!is_for_kinds_alone(rule)) return true;
    return kind != outline_name && !rule.match.kinds.empty() && names(rule, outline_name) &&
           !names(rule, kind);
}

/// The kind's own rule. It stands behind all other rules for the kind and before narrower rules.
PenRule& own_rule(Style& style, std::string_view kind) {
    std::vector<PenRule>& rules = style.pens;
    const auto is_general = [&](const PenRule& rule) {
        return is_for_kinds_alone(rule) && names(rule, kind);
    };
    const auto last = std::ranges::find_if(rules.rbegin(), rules.rend(), is_general);
    if (last != rules.rend() && is_of(*last, kind)) return *last;
    // It also stands after the last rule for the kind, however narrow the rules before that are.
    auto place = last.base();
    while (place != rules.end() && !is_narrower(*place, kind)) ++place;
    return *rules.insert(place, PenRule{.match = {.kinds = {std::string{kind}}}});
}

void take(Pen& pen, const PenRule& rule, const Style& style) {
    if (rule.width) pen.width = *rule.width;
    if (rule.width_factor) pen.width = style.pen.width * *rule.width_factor;
    if (rule.color) pen.color = *rule.color;
}

/// The object's own rule, behind all others.
PenRule& own_rule_of_object(Style& style, const std::string& object) {
    const std::string pattern = literal_pattern(object);
    const auto own = std::ranges::find_if(style.pens, [&](const PenRule& rule) {
        return rule.match.object == pattern && rule.match.kinds.empty() &&
               rule.match.material.empty() && !rule.match.hidden;
    });
    PenRule rule;
    rule.match.object = pattern;
    if (own != style.pens.end()) {
        rule = *own;
        style.pens.erase(own);
    }
    return style.pens.emplace_back(std::move(rule));
}

} // namespace

Pen pen_of_object(const Style& style, const std::string& object) {
    Pen pen = style.pen;
    for (const PenRule& rule : style.pens)
        if (rule.match.kinds.empty() && rule.match.material.empty() && !rule.match.hidden &&
            (rule.match.object.empty() || names_part(rule.match.object, object)))
            take(pen, rule, style);
    return pen;
}

void set_width_of_object(Style& style, const std::string& object, float width) {
    PenRule& rule = own_rule_of_object(style, object);
    rule.width = width;
    rule.width_factor.reset();
}

void set_color_of_object(Style& style, const std::string& object, glm::vec3 color) {
    own_rule_of_object(style, object).color = color;
}

Pen pen_of_kind(const Style& style, std::string_view kind) {
    Pen pen = style.pen;
    for (const PenRule& rule : style.pens) {
        if (is_for_kinds_alone(rule) && names(rule, kind)) take(pen, rule, style);
    }
    return pen;
}

void set_width_of_kind(Style& style, std::string_view kind, float width) {
    PenRule& rule = own_rule(style, kind);
    rule.width = width;
    rule.width_factor.reset();
}

void set_color_of_kind(Style& style, std::string_view kind, glm::vec3 color) {
    own_rule(style, kind).color = color;
}

} // namespace lineatlas::viewer
