#pragma once

#include <memory>

#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// The kernels as C++ on all cores (oneTBB), in the calling process: needs no driver. `tuning`:
/// scans must be by chunks, and the values for which kernels are compiled must be the defaults.
std::unique_ptr<Device> make_cpp_device(const Tuning& tuning = {});

/// The memory of a buffer of that device.
std::byte* memory_of_cpp(const Buffer& buffer);

} // namespace lineatlas::compute
