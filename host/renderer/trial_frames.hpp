#pragma once

#include "glpasses/interop/sharing.hpp"
#include "lineatlas/compute_device.hpp"

namespace lineatlas {

/// Checks by small frames that a device's kernels compute the same as the C++ form, as
/// compute::try_device() does. Draws in the current GL context and leaves nothing behind there.
/// `mode`: how the device will share with GL, because frames have other kernels if memory is
/// shared.
bool try_frames(const compute::Device& device, interop::SharingMode mode);

} // namespace lineatlas
