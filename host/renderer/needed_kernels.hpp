#pragma once

#include <vector>

#include "compute/stages/kernel_forms.hpp"
#include "form_costs.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// The kernels that frames with these options launch in the current GL context, whatever the lines
/// and the camera are. Kernels of pictures in tiles are not among them.
std::vector<compute::KernelForm> needed_kernels(const FrameOptions& options,
                                                const AutomaticForms& automatic,
                                                const compute::Device& device);

} // namespace lineatlas
