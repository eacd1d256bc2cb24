#pragma once

#include <memory>

#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// A device that runs kernels as C++ on all cores (oneTBB) in the calling process. It needs no
/// driver. `tuning`: scans must be by chunks, and values that kernels are compiled for must be the
/// defaults.
std::unique_ptr<Device> make_cpp_device(const Tuning& tuning = {});

/// The memory of a buffer of that device.
std::byte* memory_of_cpp(const Buffer& buffer);

} // namespace lineatlas::compute
