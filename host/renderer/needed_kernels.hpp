#pragma once

#include <vector>

#include "compute/stages/kernel_forms.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// The kernels that frames with these options launch, whatever their lines are and wherever they
/// are seen from; not those of pictures in tiles. In the current GL context.
std::vector<compute::KernelForm> needed_kernels(const FrameOptions& options,
                                                const compute::Device& device);

} // namespace lineatlas
