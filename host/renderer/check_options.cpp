#include "check_options.hpp"

#include <cmath>
#include <string>

#include "core/limits.hpp"
#include "core/line_pens.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

void check(const Pen& pen, const std::string& name) {
    if (!(pen.width > 0) || pen.width > 1000) {
        throw UsageError(name + ": width must lie above 0 and be at most 1000 pixels");
    }
    for (const Profile* profile : {&pen.width_profile, &pen.opacity_profile}) {
        if (profile->empty() || profile->size() > 16) {
            throw UsageError(name + ": a profile has 1 to 16 values, not " +
                             std::to_string(profile->size()));
        }
    }
}

void check(const DepthTexture& depth, Method method) {
    if (method != Method::atlas && method != Method::spine) {
        throw UsageError("depth: only the methods atlas and spine use a program's own depth; exact "
                         "knows no depth buffer at all");
    }
    if (depth.scale < 1 || depth.scale > 4) {
        throw UsageError("depth: scale must be 1, 2, 3 or 4, not " + std::to_string(depth.scale));
    }
    if (depth.range.x == depth.range.y) {
        throw UsageError("depth: range must hold two different numbers");
    }
}

} // namespace

void check(const FrameOptions& options) {
    if (options.depth_scale < 1 || options.depth_scale > finest_depth_scale) {
        throw UsageError("depth-scale must be 1, 2, 3 or 4, not " +
                         std::to_string(options.depth_scale));
    }
    if (!(options.step >= finest_step) || !std::isfinite(options.step)) {
        throw UsageError("step must be a number of pixels of at least 0.01");
    }
    const bool needs_runs = options.intervals != KeptIntervals::none || !options.draw;
    if (needs_runs && options.method != Method::atlas && options.method != Method::exact) {
        throw UsageError("renderer: intervals, and frames that are not drawn, need method atlas or "
                         "exact");
    }
    if (options.depth) check(*options.depth, options.method);
    check(options.style.pen, "pen");
    for (const PenRule& rule : options.style.pens)
        check(with_rule(options.style.pen, rule, options.style.pen), "pens");
    if (options.style.hidden) check(options.style.hidden_pen, "hidden pen");
}

} // namespace lineatlas
