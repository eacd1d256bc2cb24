#include "line_pens.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "base/name_pattern.hpp"
#include "flags.h"
#include "lineatlas/error.hpp"
#include "style_lengths.hpp"

namespace lineatlas {
namespace {

bool operator==(const Pen& a, const Pen& b) {
    return a.mark == b.mark && a.width == b.width && a.color == b.color && a.opacity == b.opacity &&
           a.join == b.join && a.mitre_limit == b.mitre_limit && a.cap == b.cap &&
           a.path_cap == b.path_cap && a.cap_length == b.cap_length &&
           a.width_profile == b.width_profile && a.opacity_profile == b.opacity_profile;
}

bool fits(const PenMatch& match, const MeshGroup& group) {
    return (match.object.empty() || names_part(match.object, group.object)) &&
           (match.material.empty() || matches(match.material, group.material));
}

bool names_group(const PenMatch& match) {
    return !match.object.empty() || !match.material.empty();
}

bool has_kind(const PenMatch& match, std::string_view kind) {
    return std::ranges::find(match.kinds, kind) != match.kinds.end();
}

/// Hidden lines are never outlines.
bool is_for_outlines(const PenMatch& match) {
    return !match.hidden && has_kind(match, outline_name);
}

bool fits(const PenMatch& match, const LineClasses& classes, const LineClasses::Class& line,
          bool outline) {
    const std::string_view kind = line_kind_names[static_cast<std::size_t>(line.kind)];
    if (!match.kinds.empty() && !has_kind(match, kind) &&
        !(outline && has_kind(match, outline_name)))
        return false;
    if (!names_group(match)) return true;
    const auto fits_group = [&](std::uint32_t group) {
        return group != LineClasses::no_group && fits(match, classes.groups[group]);
    };
    return fits_group(line.group_a) || fits_group(line.group_b);
}

std::string quoted_names(const std::set<std::string>& names) {
    constexpr std::size_t most = 8;
    std::string text;
    std::size_t count = 0;
    for (const std::string& name : names) {
        if (count++ == most) return text + " and " + std::to_string(names.size() - most) + " more";
        text += (text.empty() ? "\"" : ", \"") + name + "\"";
    }
    return text;
}

/// The factor for the style's lengths in a picture of this size.
float length_scale(const Style& style, glm::ivec2 size) {
    const auto shorter = static_cast<float>(std::min(size.x, size.y));
    if (!(style.made_for > 0) || !(shorter > 0)) return 1;
    return std::max(shorter / style.made_for, 1.0F); // thinner lines would fade
}

} // namespace

bool can_be_outline(LineKind kind) {
    return kind != LineKind::section && (mask_of(kind) & LA_KINDS_BESIDE) == 0;
}

void LineClasses::update(const LineSet& lines, std::uint32_t first, std::uint32_t count) {
    groups.insert(groups.end(), lines.groups.begin() + static_cast<std::ptrdiff_t>(groups.size()),
                  lines.groups.end());
    const auto group_of = [&](std::uint32_t face) {
        const std::uint32_t triangle = face & LA_FACE_INDEX;
        return face == LA_NO_FACE || triangle >= lines.triangle_group.size()
                   ? LineClasses::no_group
                   : lines.triangle_group[triangle];
    };
    for (std::uint32_t i = first; i < first + count; ++i) {
        const Segment& segment = lines.segments[i];
        std::uint32_t a = group_of(segment.face_a), b = group_of(segment.face_b);
        if (a > b) std::swap(a, b);
        const LineClasses::Class own{static_cast<LineKind>(segment.tag & LA_TAG_KIND_MASK), a, b};
        if (i > first && classes[of_segment[i - 1]] == own) {
            of_segment[i] = of_segment[i - 1];
            continue;
        }
        const auto [found, is_new] =
            numbers.emplace(own, static_cast<std::uint32_t>(classes.size()));
        if (is_new) classes.push_back(own);
        of_segment[i] = found->second;
    }
}

LineClasses line_classes(const LineSet& lines) {
    LineClasses result;
    const auto count = static_cast<std::uint32_t>(lines.segments.size());
    result.of_segment.resize(count);
    result.update(lines, 0, count);
    return result;
}

Pen with_rule(Pen pen, const PenRule& rule, const Pen& own) {
    const auto take = [](const auto& given, auto& member) {
        if (given) member = *given;
    };
    take(rule.mark, pen.mark);
    take(rule.width, pen.width);
    if (rule.width_factor) pen.width = own.width * *rule.width_factor;
    take(rule.color, pen.color);
    take(rule.opacity, pen.opacity);
    take(rule.join, pen.join);
    take(rule.mitre_limit, pen.mitre_limit);
    take(rule.cap, pen.cap);
    take(rule.path_cap, pen.path_cap);
    take(rule.cap_length, pen.cap_length);
    take(rule.width_profile, pen.width_profile);
    take(rule.opacity_profile, pen.opacity_profile);
    return pen;
}

bool LinePens::tell_outlines() const {
    return std::ranges::any_of(of_class,
                               [](const OfClass& own) { return own.inner != own.outline; });
}

float widest(const std::vector<Pen>& pens) {
    return std::ranges::max_element(pens, {}, &Pen::width)->width;
}

LinePens line_pens(const LineClasses& classes, const Style& style) {
    LinePens result;
    result.pens.push_back(style.pen);
    result.hidden.push_back(style.hidden_pen);
    result.of_class.resize(classes.classes.size());
    enum class Look { inner, outline, hidden };
    const auto pen_of = [&](const LineClasses::Class& line, Look look) {
        std::vector<Pen>& pens = look == Look::hidden ? result.hidden : result.pens;
        const Pen& own = look == Look::hidden ? style.hidden_pen : style.pen;
        Pen pen = own;
        for (const PenRule& rule : style.pens)
            if (rule.match.hidden == (look == Look::hidden) &&
                fits(rule.match, classes, line, look == Look::outline))
                pen = with_rule(std::move(pen), rule, own);
        const auto known =
            std::ranges::find_if(pens, [&](const Pen& other) { return other == pen; });
        if (known != pens.end()) return static_cast<std::uint32_t>(known - pens.begin());
        pens.push_back(pen);
        return static_cast<std::uint32_t>(pens.size() - 1);
    };
    for (std::size_t i = 0; i < classes.classes.size(); ++i) {
        result.of_class[i].inner = pen_of(classes.classes[i], Look::inner);
        result.of_class[i].hidden = pen_of(classes.classes[i], Look::hidden);
    }
    for (std::size_t i = 0; i < classes.classes.size(); ++i) {
        const LineClasses::Class& line = classes.classes[i];
        result.of_class[i].outline =
            can_be_outline(line.kind) ? pen_of(line, Look::outline) : result.of_class[i].inner;
    }
    const std::size_t most = std::max(result.pens.size(), result.hidden.size());
    if (most > LA_RUN_PEN_MASK + 1) {
        throw UsageError("the style's rules make " + std::to_string(most) +
                         " different pens for these lines; there may be " +
                         std::to_string(LA_RUN_PEN_MASK + 1));
    }
    return result;
}

bool tells_outlines(const Style& style) {
    return std::ranges::any_of(style.pens,
                               [](const PenRule& rule) { return is_for_outlines(rule.match); });
}

float outline_depth(const Style& style, glm::ivec2 size) {
    float widest = 0;
    for (const PenRule& rule : style.pens) {
        if (!is_for_outlines(rule.match)) continue;
        const float width = rule.width.value_or(style.pen.width);
        widest = std::max(widest, rule.width_factor ? style.pen.width * *rule.width_factor : width);
    }
    return 2 * widest * length_scale(style, size);
}

LineKindMask drawn_kinds(std::optional<LineKindMask> asked, const Style& style) {
    return asked.value_or(usual_line_kinds | style.more_lines);
}

float centre_overhang(const Style& style, glm::ivec2 size) {
    return style.centre_overhang * length_scale(style, size);
}

std::vector<std::string> idle_rules(const LineClasses& classes, const Style& style) {
    std::set<std::string> objects, materials;
    for (const MeshGroup& group : classes.groups) {
        if (!group.object.empty()) objects.insert(group.object);
        if (!group.material.empty()) materials.insert(group.material);
    }
    std::vector<std::string> lines;
    const auto is_for_hidden = [](const PenRule& rule) { return rule.match.hidden; };
    if (!style.hidden && std::ranges::any_of(style.pens, is_for_hidden))
        lines.emplace_back("pens: there are rules for hidden lines, which are not drawn; "
                           "hidden = true draws them");
    for (const PenRule& rule : style.pens) {
        const PenMatch& match = rule.match;
        const auto fits_one = [&](const MeshGroup& group) { return fits(match, group); };
        if (!names_group(match) || std::ranges::any_of(classes.groups, fits_one)) continue;
        std::string text = "pens: nothing";
        if (!match.object.empty()) text += " is called \"" + match.object + "\"";
        if (!match.object.empty() && !match.material.empty()) text += " and";
        if (!match.material.empty()) text += " has the material \"" + match.material + "\"";
        const std::set<std::string>& known = match.object.empty() ? materials : objects;
        lines.push_back(text + (known.empty() ? "; the model names none"
                                              : "; there is " + quoted_names(known)));
    }
    return lines;
}

void scale_lengths(Style& style, glm::ivec2 size) {
    multiply_lengths(style, length_scale(style, size));
}

} // namespace lineatlas
