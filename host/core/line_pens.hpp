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

/// Lines of a file lie in the open, and those of a cut have a meaning of their own: they are no
/// outline wherever they lie.
bool can_be_outline(LineKind kind);

/// What rules for pens can tell lines apart by: segments of one class get the same pens.
struct LineClasses {
    static constexpr std::uint32_t no_group = 0xFFFFFFFF;
    struct Class {
        LineKind kind;
        std::uint32_t group_a; ///< of the faces beside the line, into `groups`, or no_group
        std::uint32_t group_b;
        auto operator<=>(const Class&) const = default;
    };
    std::vector<std::uint32_t> of_segment; ///< into `classes`
    std::vector<Class> classes;
    std::vector<MeshGroup> groups;
    std::map<Class, std::uint32_t> numbers; ///< of `classes`

    /// Other segments stand from `first` on, so many, perhaps of new groups.
    void update(const LineSet& lines, std::uint32_t first, std::uint32_t count);
};

LineClasses line_classes(const LineSet& lines);

/// The pens of a style for the classes of a line set.
struct LinePens {
    /// Each once, the style's own first, those of outlines last: in the order of drawing.
    std::vector<Pen> pens;
    std::vector<Pen> hidden; ///< of hidden lines, likewise
    /// Per class, into `pens`.
    struct OfClass {
        std::uint32_t inner = 0;
        std::uint32_t outline = 0; ///< of what is beside the background
        std::uint32_t hidden = 0;  ///< into `hidden`
        bool operator==(const OfClass&) const = default;
    };
    std::vector<OfClass> of_class;

    /// Whether a class has another pen for outlines.
    bool tell_outlines() const;
};

float widest(const std::vector<Pen>& pens);

/// Throws UsageError for more pens than a run can name.
LinePens line_pens(const LineClasses& classes, const Style& style);

/// The pen with what a rule says of it. `own`: the style's own, whose width factors are of.
Pen with_rule(Pen pen, const PenRule& rule, const Pen& own);

/// Whether rules of the style tell outlines from other lines.
bool tells_outlines(const Style& style);

/// How deep a body must be behind its outline, in pixels of a picture of this size, or the outline
/// is drawn as an inner line is: twice the widest pen that a rule gives to outlines.
float outline_depth(const Style& style, glm::ivec2 size);

/// The kinds of line that a drawing has: those asked for, or else the usual ones and the style's.
LineKindMask drawn_kinds(std::optional<LineKindMask> asked, const Style& style);

/// Pixels that centre lines are longer at either end in a picture of this size.
float centre_overhang(const Style& style, glm::ivec2 size);

/// Of every rule that is for no object or material of these lines, what it asks for and what there
/// is, as a line for people.
std::vector<std::string> idle_rules(const LineClasses& classes, const Style& style);

/// Gives the style the lengths of a picture of this size, see Style::made_for.
void scale_lengths(Style& style, glm::ivec2 size);

} // namespace lineatlas
