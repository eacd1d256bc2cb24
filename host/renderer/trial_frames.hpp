#pragma once

#include "glpasses/interop/sharing.hpp"
#include "lineatlas/compute_device.hpp"

namespace lineatlas {

/// Has a device prove by small frames that its kernels compute what C++ does, as
/// compute::try_device(), in the current GL context, of which nothing is left behind. `mode`: how
/// the device will share with it, since frames have other kernels where it shares memory.
bool try_frames(const compute::Device& device, interop::SharingMode mode);

} // namespace lineatlas
