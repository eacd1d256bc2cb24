#include "frame_forms.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "core/line_pens.hpp"
#include "core/pens.hpp"
#include "glpasses/current_context.hpp"

namespace lineatlas {
namespace {

// No turn that is joined at all has a longer mitre (LA_JOIN_LIMIT_COSINE).
constexpr float longest_mitre = 4;

// The fewest triangles for which a GPU culls clusters. Culling takes half a millisecond to hand
// depth over and back. A GPU draws about this many triangles in that time (docs/benchmarks.md).
constexpr std::uint32_t fewest_culled_by_gpus = 1U << 20U;

bool is_constant(const Profile& profile) {
    return profile.size() == 1 && profile[0] == 1;
}

/// Whether a mark is the same all across the stroke, at any width.
bool is_even(const std::string& mark) {
    if (mark == "solid") return true;
    const std::optional<DashLengths> dashes = dash_lengths(mark, 1);
    return dashes && !dashes->round;
}

} // namespace

std::uint32_t fewest_culled_triangles() {
    return gl::is_software() ? 0 : fewest_culled_by_gpus;
}

bool wants_depth_kernels(const FrameOptions& options, const AutomaticForms& automatic) {
    if (options.own_depth || options.method == Method::item_buffer ||
        options.method == Method::opengl)
        return false;
    if (options.forms.depth != StageForm::automatic)
        return options.forms.depth == StageForm::compute;
    if (options.method == Method::spine) return automatic.spine_depth;
    return options.method == Method::exact ? automatic.fill : automatic.depth;
}

bool wants_stroke_kernels(const FrameOptions& options, const AutomaticForms& automatic) {
    const bool asked = options.forms.strokes == StageForm::compute ||
                       (options.forms.strokes == StageForm::automatic && automatic.strokes);
    return options.draw && asked && !options.style.focus.on;
}

bool is_plain(const Pen& pen) {
    const auto is_plain_cap = [](Cap cap) { return cap == Cap::butt || cap == Cap::round; };
    const bool has_bevels =
        pen.join == Join::bevel || (pen.join == Join::mitre && pen.mitre_limit < longest_mitre);
    return is_even(pen.mark) && is_plain_cap(pen.cap) && is_plain_cap(pen.path_cap) &&
           !has_bevels && is_constant(pen.width_profile) && is_constant(pen.opacity_profile);
}

bool wants_steadiness(const FrameOptions& options) {
    return options.steady && options.method == Method::atlas && options.probes > 1;
}

bool needs_filter(const FrameOptions& options, std::span<const Pen> pens) {
    const StrokeFilter& f = options.style.filter;
    const bool changes_lengths =
        f.fill_holes > 0 || f.drop_runs > 0 || f.overshoot > 0 || f.undershoot > 0 || f.halo > 0;
    const auto varies = [](const Profile& profile) { return profile.size() > 1; };
    const auto ends_anew = [&](const Pen& pen) {
        const bool has_caps =
            pen.cap != Cap::butt || pen.path_cap == Cap::taper || pen.path_cap == Cap::texture;
        return has_caps || varies(pen.width_profile) || varies(pen.opacity_profile);
    };
    return options.draw && (changes_lengths || std::ranges::any_of(pens, ends_anew));
}

bool has_textures(const FrameOptions& options, std::span<const Pen> pens,
                  std::span<const Pen> hidden_pens) {
    const Style& style = options.style;
    const auto is_texture = [](const std::string& mark) {
        return !mark.empty() && mark != "solid";
    };
    const auto textured = [&](const Pen& pen) {
        return is_texture(pen.mark) || pen.cap == Cap::texture || pen.path_cap == Cap::texture;
    };
    return options.draw && (std::ranges::any_of(pens, textured) ||
                            (style.hidden && std::ranges::any_of(hidden_pens, textured)) ||
                            (style.focus.on && is_texture(style.focus.mark)));
}

bool needs_outlines(const FrameOptions& options) {
    const bool asked = options.draw || options.intervals != KeptIntervals::none;
    return asked && tells_outlines(options.style);
}

} // namespace lineatlas
