#pragma once

#include <algorithm>
#include <cstdint>

#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// The most tables of any kernel.
inline constexpr std::size_t most_tables = 17;

/// Bytes that a launch reads and writes if it touches its tables once: their sizes, doubled for
/// tables that are both read and written. A table that stands in for an absent one is not counted
/// again.
inline std::uint64_t bytes_moved(const Launch& launch) {
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < launch.tables.size(); ++i) {
        if (std::ranges::count(launch.tables.first(i), launch.tables[i]) > 0) continue;
        const Access access = launch.kernel.tables[i].access;
        const bool twice = access == Access::inout || access == Access::unordered;
        bytes += launch.tables[i]->size() * (twice ? 2 : 1);
    }
    return bytes;
}

} // namespace lineatlas::compute
