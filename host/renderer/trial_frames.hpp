#pragma once

#include "glpasses/interop/sharing.hpp"
#include "lineatlas/compute_device.hpp"

namespace lineatlas {

/// Checks by small frames that a device's kernels compute what C++ does, as compute::try_device(),
/// in the current GL context, in which nothing stays behind. `mode`: how the device will share with
/// GL, since frames have other kernels if memory is shared.
bool try_frames(const compute::Device& device, interop::SharingMode mode);

} // namespace lineatlas
