#pragma once

#include <memory>

#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// The kernels as C++ on all cores (oneTBB), in the calling process: needs no driver.
std::unique_ptr<Device> make_cpp_device();

} // namespace lineatlas::compute
