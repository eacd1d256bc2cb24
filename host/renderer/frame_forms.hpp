#pragma once

#include <span>

#include "form_costs.hpp"
#include "lineatlas/renderer.hpp"

// Which stages of a frame kernels run, and which stages its style needs, as far as that is known
// before the frame's lines are known.
namespace lineatlas {

/// The fewest triangles for which GL draws only clusters that may be seen. A GPU has drawn fewer
/// triangles before it is known which to draw.
std::uint32_t fewest_culled_triangles();

/// Whether depth, and a fill by it, is drawn by kernels, where the frame draws any.
bool wants_depth_kernels(const FrameOptions& options, const AutomaticForms& automatic);
/// Whether kernels draw strokes, if they know all pens and there are many runs.
bool wants_stroke_kernels(const FrameOptions& options, const AutomaticForms& automatic);
/// Whether kernels know all that the pen does.
bool is_plain(const Pen& pen);

/// Whether frames are averaged with those before them, if all segments are in one table.
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
