#pragma once

#include <algorithm>
#include <cstdint>

#include "core/host_clock.hpp"

namespace lineatlas::compute {

/// The highest rate of `work` in a fifth of a second, per nanosecond: other work of the machine can
/// only slow it down. `work` returns how much it has done.
template <class Work>
double best_rate(const Work& work) {
    constexpr std::int64_t while_ns = 200'000'000;
    double best = 0;
    const std::int64_t end = host_nanoseconds() + while_ns;
    do {
        const std::int64_t start = host_nanoseconds();
        const auto done = static_cast<double>(work());
        const auto taken =
            static_cast<double>(std::max<std::int64_t>(host_nanoseconds() - start, 1));
        best = std::max(best, done / taken);
    } while (host_nanoseconds() < end);
    return best;
}

} // namespace lineatlas::compute
