#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "style_numbers.h"

/// @file
/// The look of a drawing: pens, changes along lines, density, fill, paper.
/// @code{.cpp}
/// Style red = default_style();
/// red.pen.color = {0.7F, 0.1F, 0.1F};
/// red.filter.overshoot = 6;
/// red.pens.push_back({.match = {.kinds = {"outline"}}, .width = 5});
/// @endcode

namespace lineatlas {

/// How two segments of a path meet.
enum class Join {
    mitre, ///< pointed, up to Pen::mitre_limit
    round, ///< an arc around the corner
    bevel, ///< cut off
};

/// How a stroke ends.
enum class Cap {
    butt,    ///< cut square
    round,   ///< a half disc beyond the end
    taper,   ///< narrowing to a point over `Pen::cap_length`
    texture, ///< running dry over `Pen::cap_length`, as the mark's grain has it
};

/// Values from the start to the end of a stroke, evenly spaced, at most 16; a single one: constant.
using Profile = std::vector<float>;

/// The pen that draws a line. Lengths are in pixels.
struct Pen {
    /// A built-in mark (solid, fine, pencil, charcoal, brush, dashed, dotted, chain) or an image
    /// file. The image lies along the stroke and repeats; its height is the stroke's width. Its
    /// alpha is coverage, or its darkness if it has no alpha.
    std::string mark = "solid";
    float width = 2;          ///< above 0, at most 1000
    glm::vec3 color{0, 0, 0}; ///< RGB, 0 to 1
    float opacity = 1;        ///< 0 to 1
    Join join = Join::mitre;  ///< how its segments meet
    /// Longest mitre in stroke widths, 1 to 100; beyond it the join is bevelled (as in SVG).
    float mitre_limit = 4;
    Cap cap = Cap::butt;        ///< where visibility ends
    Cap path_cap = Cap::round;  ///< where the path itself ends
    float cap_length = 12;      ///< of tapered and textured caps, 0 to 10000
    Profile width_profile{1};   ///< factors of the width along a visible stroke, 0 to 4
    Profile opacity_profile{1}; ///< factors of the opacity, 0 to 1
};

/// How faces are coloured.
enum class FillMode {
    none,    ///< not at all
    flat,    ///< evenly
    lambert, ///< by their angle to the light
    toon,    ///< the same in `Fill::toon_steps` tones
};

/// Colours under the lines.
struct Fill {
    FillMode mode = FillMode::none;     ///< how faces are coloured
    glm::vec3 color{0.9F, 0.9F, 0.88F}; ///< of triangles without a material's colour
    glm::vec3 light{0.4F, 0.8F, 0.5F};  ///< direction to the light, in eye space; not 0
    float ambient = 0.35F;              ///< what is not lit, 0 to 1
    int toon_steps = 3;                 ///< 2 to 8
};

/// What is drawn on.
struct Paper {
    glm::vec3 color{1, 1, 1}; ///< RGB, 0 to 1
    float grain = 0;          ///< strength of the paper's texture over the drawing, 0 to 1
};

/// Style that varies with the distance from a focus (§6, Fig. 13). Between `radius` and `radius` +
/// `falloff` each number changes smoothly from its own value to its value far away.
struct Focus {
    bool on = false;       ///< false: all is near
    bool in_scene = false; ///< `point` is one of the model, else one of the window
    /// Of the model: relative to the origin of the mesh (LoadedMesh::origin), as its positions are.
    /// Of the window: shares of its width and height from the lower left.
    glm::dvec3 point{0.5, 0.5, 0};
    /// Shares of the window's height, or of the model's diagonal; 0 to 1000.
    float radius = 0.2F;
    float falloff = 0.3F;     ///< from the end of `radius` to far away, in the same unit
    float width = 0.5F;       ///< factor of the width far away, 0 to 100
    float opacity = 0.4F;     ///< factor of the opacity far away, 0 to 1
    float hidden_opacity = 0; ///< factor of the hidden lines' opacity far away, 0 to 1
    float density = 1;        ///< factor of the density limit far away, 0 to 100
    std::string mark{};       ///< the pen's mark far away; empty: the same
};

/// The lines that a PenRule is for: those that meet all its conditions. An empty member is no
/// condition.
struct PenMatch {
    /// Any of these: names of `line_kind_names`, or "outline". Outline is the part of a visible
    /// line that has the model on one side and the background on the other. Lines of files and of
    /// cuts are never outlines.
    std::vector<std::string> kinds{};
    /// MeshGroup::object of a face beside the line, or one name of that path: "Bolt*" fits
    /// "arm/Bolt 2" and the parts in it. `*` stands for any letters, `?` for one.
    std::string object{};
    std::string material{}; ///< MeshGroup::material of the same face, as a whole
    bool hidden = false;    ///< hidden lines (Style::hidden); else visible ones
};

/// A change of the pen of some lines: members that are set replace those of the pen.
struct PenRule {
    PenMatch match{};                  ///< which lines it is for
    std::optional<std::string> mark{}; ///< Pen::mark
    std::optional<float> width{};      ///< Pen::width
    /// Factor of the style's own width, in place of `width`; 0.01 to 100.
    std::optional<float> width_factor{};
    std::optional<glm::vec3> color{};         ///< Pen::color
    std::optional<float> opacity{};           ///< Pen::opacity
    std::optional<Join> join{};               ///< Pen::join
    std::optional<float> mitre_limit{};       ///< Pen::mitre_limit
    std::optional<Cap> cap{};                 ///< Pen::cap
    std::optional<Cap> path_cap{};            ///< Pen::path_cap
    std::optional<float> cap_length{};        ///< Pen::cap_length
    std::optional<Profile> width_profile{};   ///< Pen::width_profile
    std::optional<Profile> opacity_profile{}; ///< Pen::opacity_profile
};

/// How a drawing looks. Keys of style files and options of the tool have the names of these
/// members, and the same ranges (docs/styles.md). A call that draws throws UsageError, before it
/// draws, for a member that is out of its range.
struct Style {
    Pen pen{};           ///< of visible lines
    bool hidden = false; ///< draw hidden lines too, with their own pen, under the visible ones
    /// Of hidden lines.
    Pen hidden_pen{.mark = "dashed", .width = 1, .color = {0.45F, 0.45F, 0.45F}};
    StrokeFilter filter{}; ///< changes along the lines; lengths from 0 to 10000 pixels
    Density density{};     ///< what is left out where lines are dense; Density::limit 0 to 100
    /// Kinds of line that the style draws besides the usual ones: a LineKindMask. They must have
    /// been extracted (LineOptions::lines).
    std::uint32_t more_lines = 0;
    /// Pixels by which centre lines reach beyond their surface at either end, 0 to 10000; the
    /// default is 3 mm on paper.
    float centre_overhang = 11.34F;
    /// The most pixels of hidden line per pixel of the picture, 0 to 100, by the priorities of
    /// `density`; 0: no limit.
    float hidden_density = 0;
    Fill fill{};   ///< under the lines
    Paper paper{}; ///< what is drawn on
    Focus focus{}; ///< what stands out
    /// Rules that change pens, in this order: every rule that matches a line changes `pen`, or
    /// `hidden_pen` if the line is hidden.
    std::vector<PenRule> pens{};
    /// Shorter side, in pixels, of the picture that the lengths are meant for, 1 to 65536. In a
    /// larger picture lengths grow in proportion; in a smaller one they stay the same. 0: lengths
    /// are pixels in every picture.
    float made_for = 0;
};

} // namespace lineatlas
