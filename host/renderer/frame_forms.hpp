#pragma once

#include <span>
#include <string_view>

#include "lineatlas/compute_device.hpp"
#include "lineatlas/renderer.hpp"

// Which stages of a frame run by kernels, and which its style needs, as far as that is known before
// the frame's lines are.
namespace lineatlas {

/// Whether kernels draw depth, fills and strokes faster than GL: where both run on the CPU. In the
/// current GL context.
bool kernels_are_faster(const compute::Tuning& tuning);
/// Whether GL computes samples faster than kernels, with all that has to cross: where it has a GPU
/// and kernels have none.
bool gl_samples_faster(const compute::Tuning& tuning);
/// Which forms `automatic` takes with such a device, and why: a few words.
std::string_view describe_forms(const compute::Tuning& tuning);
/// The fewest triangles of which GL draws those alone that may be seen. A GPU has drawn fewer
/// before it is known which.
std::uint32_t fewest_culled_triangles();

/// Whether depth, and a fill by it, is drawn by kernels, where the frame draws any.
bool wants_depth_kernels(const FrameOptions& options, bool kernels_are_faster);
/// Whether strokes are, where kernels know all pens and there are many runs.
bool wants_stroke_kernels(const FrameOptions& options, bool kernels_are_faster);
/// Whether kernels know all that the pen does.
bool is_plain(const Pen& pen);

/// Whether frames are averaged with those before them, where all segments are in one table.
bool wants_steadiness(const FrameOptions& options);
/// Whether anything of the style concerns whole strokes, not runs of single segments. `pens`: of
/// visible lines.
bool needs_filter(const FrameOptions& options, std::span<const Pen> pens);
/// Whether anything that is drawn has a texture along its strokes: dashes, grain, dry ends.
bool has_textures(const FrameOptions& options, std::span<const Pen> pens,
                  std::span<const Pen> hidden_pens);
/// Whether frames tell outlines from other lines.
bool needs_outlines(const FrameOptions& options);

} // namespace lineatlas
