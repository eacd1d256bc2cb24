#pragma once

#include <cstdint>

/// A layer between the OpenCL loader and a driver for a CPU (OPENCL_LAYERS). It lets the CPU look
/// like a card with its own memory. The device says that it is a GPU, shares no memory with the
/// host, and lets the host wait as for a bus: 10 us and 4 GB/s for a copy, 5 us for a launch.
namespace lineatlas::test {

struct BusCounts {
    std::uint32_t launches; ///< of kernels
    std::uint32_t copies;   ///< between the host and the device
    std::uint64_t bytes;    ///< bytes of all copies
    std::uint32_t waits;    ///< of the host for the device: clFinish, and copies that block
};

/// The type of the function that the layer exports. It returns the counts since its last call.
using TakeBusCounts = BusCounts();
inline constexpr const char* take_bus_counts_symbol = "lineatlas_test_take_bus_counts";

} // namespace lineatlas::test

extern "C" lineatlas::test::BusCounts lineatlas_test_take_bus_counts();
