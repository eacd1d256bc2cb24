#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lineatlas {

/// A part of a line, from one place along it to another: pixels from its start, or shares.
struct Stretch {
    double from = 0, to = 0;
};

/// Sorts stretches and joins those with less than `gap` between them.
inline void join_stretches(std::vector<Stretch>& stretches, double gap) {
    std::ranges::sort(stretches, {}, &Stretch::from);
    std::size_t count = 0;
    for (const Stretch stretch : stretches) {
        if (count > 0 && stretch.from - stretches[count - 1].to < gap)
            stretches[count - 1].to = std::max(stretches[count - 1].to, stretch.to);
        else
            stretches[count++] = stretch;
    }
    stretches.resize(count);
}

} // namespace lineatlas
