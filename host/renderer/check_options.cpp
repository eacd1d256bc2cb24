#include "check_options.hpp"

#include <cmath>
#include <string>

#include "core/limits.hpp"
#include "lineatlas/error.hpp"
#include "style/frame_settings.hpp"
#include "style/settings.hpp"

namespace lineatlas {
namespace {

void check(const DepthTexture& depth, Method method) {
    if (method != Method::atlas && method != Method::spine) {
        throw UsageError(
            "depth: only the methods atlas and spine use a program's own depth; choose "
            "one of them as FrameOptions::method, or leave out own_depth");
    }
    if (depth.scale < 1 || depth.scale > finest_depth_scale) {
        throw UsageError("depth: DepthTexture::scale must be 1, 2, 3 or 4, not " +
                         std::to_string(depth.scale));
    }
    if (depth.range.x == depth.range.y || !std::isfinite(depth.range.x) ||
        !std::isfinite(depth.range.y)) {
        throw UsageError("depth: DepthTexture::range must hold two different, finite numbers");
    }
}

} // namespace

void check(const FrameOptions& options) {
    check_frame_options(options);
    if (options.intervals > KeptIntervals::all)
        throw UsageError("FrameOptions::intervals must be one of none, visible, all");
    const bool needs_runs = options.intervals != KeptIntervals::none || !options.draw;
    if (needs_runs && options.method != Method::atlas && options.method != Method::exact) {
        throw UsageError("renderer: intervals, and frames that are not drawn, need "
                         "FrameOptions::method atlas or exact");
    }
    if (options.own_depth) check(*options.own_depth, options.method);
    check_style(options.style);
}

} // namespace lineatlas
