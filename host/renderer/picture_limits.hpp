#pragma once

#include "compute/stages/stages.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// The longest side of a picture: beyond it floats can't tell texels apart.
constexpr int longest_picture_side = 65536;
/// Throws UsageError for a picture that is longer, or empty.
void check_picture(glm::ivec2 size);

/// Depth texels around a tile that the samples in it may probe.
int probe_margin(float step, int depth_scale);

/// See Renderer::tile_size().
int tile_size_for(glm::ivec2 size, const FrameOptions& options, const compute::Device& device);

} // namespace lineatlas
