#pragma once

#include <chrono>
#include <cstdint>

namespace lineatlas {

/// The clock of profiles: nanoseconds of std::chrono::steady_clock.
inline std::int64_t host_nanoseconds() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

} // namespace lineatlas
