#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/lines.hpp"
#include "lineatlas/style.hpp"

namespace lineatlas {

/// The name of outlines in PenMatch::kinds, beside those of LineKind.
inline constexpr const char* outline_name = "outline";

/// False for lines of a file, which lie in the open, and for lines of a cut, which have their own
/// meaning.
bool can_be_outline(LineKind kind);

/// Classes of segments. Rules for pens cannot tell segments of one class apart, so these get the
/// same pens.
struct LineClasses {
    static constexpr std::uint32_t no_group = 0xFFFFFFFF;
    struct Class {
        LineKind kind;
        std::uint32_t group_a; ///< of a face beside the line: an index into `groups`, or no_group
        std::uint32_t group_b;
        auto operator<=>(const Class&) const = default;
    };
    std::vector<std::uint32_t> of_segment; ///< indices into `classes`
    std::vector<Class> classes;
    std::vector<MeshGroup> groups;
    std::map<Class, std::uint32_t> numbers; ///< of `classes`

    /// Classifies `count` segments from `first` on again after they have changed, perhaps to new
    /// groups.
    void update(const LineSet& lines, std::uint32_t first, std::uint32_t count);
};

LineClasses line_classes(const LineSet& lines);

/// The pens of a style for the classes of a line set.
struct LinePens {
    /// Every pen once, in the order of drawing: the style's own first, those of outlines last.
    std::vector<Pen> pens;
    std::vector<Pen> hidden; ///< pens of hidden lines, likewise
    /// The pens of a class, as indices into `pens`.
    struct OfClass {
        std::uint32_t inner = 0;
        std::uint32_t outline = 0; ///< where the line borders the background
        std::uint32_t hidden = 0;  ///< an index into `hidden`
        bool operator==(const OfClass&) const = default;
    };
    std::vector<OfClass> of_class;

    /// True if a class has another pen for outlines.
    bool tell_outlines() const;
};

float widest(const std::vector<Pen>& pens);

/// Finds the pens of every class. Throws UsageError for more pens than a run can name.
LinePens line_pens(const LineClasses& classes, const Style& style);

/// The pen changed as a rule asks. own: the style's own pen, to whose width the rule's factors
/// refer.
Pen with_rule(Pen pen, const PenRule& rule, const Pen& own);

/// True if rules of the style tell outlines from other lines.
bool tells_outlines(const Style& style);

/// The least depth of a body behind its outline, in pixels of a picture of this size: twice the
/// widest pen that a rule gives to outlines. The outline of a flatter body is drawn as an inner
/// line.
float outline_depth(const Style& style, glm::ivec2 size);

/// The kinds of line that a drawing has: those asked for, or else the usual ones and the style's.
LineKindMask drawn_kinds(std::optional<LineKindMask> asked, const Style& style);

/// The pixels by which a centre line is extended at either end in a picture of this size.
float centre_overhang(const Style& style, glm::ivec2 size);

/// A message about every rule that fits no object or material of these lines: what the rule asks
/// for, and what there is.
std::vector<std::string> idle_rules(const LineClasses& classes, const Style& style);

/// Scales the style's lengths to a picture of this size, see Style::made_for.
void scale_lengths(Style& style, glm::ivec2 size);

} // namespace lineatlas
