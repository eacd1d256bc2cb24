#pragma once

#include <cstdint>
#include <limits>

#include "sharing.hpp"

namespace lineatlas::interop {

/// What it takes to pass a table to one side.
struct HandoverRate {
    double milliseconds = 0; ///< for a table of few bytes
    /// For what must be copied. Infinite if both sides have the same memory.
    double bytes_per_millisecond = std::numeric_limits<double>::infinity();

    /// Milliseconds for so many bytes.
    double of(std::uint64_t bytes) const {
        return milliseconds + static_cast<double>(bytes) / bytes_per_millisecond;
    }
};

/// What it takes to pass tables between GL and a device.
struct HandoverRates {
    HandoverRate to_compute, to_gl;
    bool measured = false; ///< on this machine, by this or an earlier process

    /// Whether bytes are copied.
    bool copies() const {
        return to_gl.bytes_per_millisecond < HandoverRate{}.bytes_per_millisecond;
    }
};

/// Rates that are taken where nothing is measured (docs/benchmarks.md).
HandoverRates assumed_rates(SharingMode mode);

/// The rates of a device and the current GL context. They are measured once, in about 30 ms, and
/// kept in the user's cache for this device, driver, GL and mode, as powers of two. So processes
/// get the same rates, except those that measure at the same time. Rates are assumed in three
/// cases: they cannot be kept (LINEATLAS_CACHE=off), the device is not OpenCL's, or GL and kernels
/// both run on the CPU, where rates change nothing. Throws DeviceError as tables do.
HandoverRates handover_rates(Sharing& sharing);

} // namespace lineatlas::interop
