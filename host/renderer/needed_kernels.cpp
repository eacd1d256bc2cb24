#include "needed_kernels.hpp"

#include <initializer_list>
#include <string_view>

#include "core/line_pens.hpp"
#include "frame.hpp"
#include "frame_forms.hpp"

namespace lineatlas {
namespace {

/// Names of stages, some of them more than once.
using Stages = std::vector<std::string_view>;

void add(Stages& stages, std::initializer_list<std::string_view> more) {
    stages.insert(stages.end(), more);
}

/// The style's own pen, and that pen changed by each rule alone. Two rules together bring in
/// nothing that stages look for unless one of them does alone.
std::vector<Pen> possible_pens(const Style& style, bool hidden) {
    const Pen& own = hidden ? style.hidden_pen : style.pen;
    std::vector<Pen> pens{own};
    for (const PenRule& rule : style.pens)
        if (rule.match.hidden == hidden) pens.push_back(with_rule(own, rule, own));
    return pens;
}

/// Adds the stages by which a style changes and draws runs.
void add_run_stages(Stages& stages, const FrameOptions& options, const AutomaticForms& automatic) {
    const Style& style = options.style;
    const std::vector<Pen> pens = possible_pens(style, false), hidden = possible_pens(style, true);
    if (needs_outlines(options)) add(stages, {"outline"});
    if (!options.draw) return;
    if (needs_filter(options, pens)) add(stages, {"filter"});
    if (style.filter.halo > 0) add(stages, {"halo"});
    if (style.density.limit > 0 || (style.hidden && style.hidden_density > 0))
        add(stages, {"density"});
    if (!style.pens.empty()) add(stages, {"pens"});
    // Rules may make any pen plain.
    const bool may_be_plain =
        !style.pens.empty() ||
        (is_plain(style.pen) && (!style.hidden || is_plain(style.hidden_pen)));
    if (wants_stroke_kernels(options, automatic) && may_be_plain) add(stages, {"strokes"});
    if (wants_steadiness(options) && has_textures(options, pens, hidden)) add(stages, {"carry"});
}

/// Adds the stages of depth, and those that prepare looking at it.
void add_depth_stages(Stages& stages, const FrameOptions& options, bool by_kernels) {
    if (by_kernels)
        add(stages, {"depth"});
    else if (options.cull_hidden)
        add(stages, {"pyramid", "cull"});
    if (!options.own_depth) add(stages, {"planes"});
}

Stages needed_stages(const FrameOptions& options, const AutomaticForms& automatic) {
    const bool depth_by_kernels = wants_depth_kernels(options, automatic);
    Stages stages{"transform", "contour"}; // for models that move
    if (options.method == Method::opengl) return stages;
    if (options.style.fill.mode != FillMode::none && depth_by_kernels) {
        add(stages, {"fill"});
        if (options.method == Method::exact) add(stages, {"depth"});
    }
    if (options.method == Method::atlas || options.method == Method::spine)
        add_depth_stages(stages, options, depth_by_kernels);
    if (options.method == Method::spine) return stages;

    add(stages, {"project_clip", "scan"});
    if ((drawn_kinds(options.lines, options.style) & mask_of(LineKind::silhouette)) != 0)
        add(stages, {"facing", "silhouette", "chain"});
    add_run_stages(stages, options, automatic);
    if (options.method == Method::exact) {
        add(stages, {"surfaces", "tile_lists", "visible", "spans"});
        return stages;
    }
    add(stages, {"compact"});
    if (options.method == Method::item_buffer) return stages;
    // The automatic form leaves large pictures to kernels.
    if (options.forms.atlas != StageForm::raster) add(stages, {"atlas"});
    if (wants_steadiness(options)) add(stages, {"temporal"});
    if (options.intervals != KeptIntervals::none) add(stages, {"intervals"});
    return stages;
}

} // namespace

std::vector<compute::KernelForm> needed_kernels(const FrameOptions& options,
                                                const AutomaticForms& automatic,
                                                const compute::Device& device) {
    const Stages stages = needed_stages(options, automatic);
    return compute::kernel_forms(stages, probes_per_axis(options.probes), device.tuning());
}

} // namespace lineatlas
