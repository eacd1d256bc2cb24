#pragma once

#include "compute/stages/stages.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// Depth texels around a tile that the samples in it may probe.
int probe_margin(float step, int depth_scale);

/// See Renderer::tile_size().
int tile_size_for(glm::ivec2 size, const FrameOptions& options, const compute::Device& device);

} // namespace lineatlas
