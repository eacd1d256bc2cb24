#include "equal_positions.hpp"

#include <algorithm>
#include <atomic>
#include <bit>

#include "first_seen.hpp"
#include "parallel.hpp"

namespace lineatlas {

std::vector<std::uint32_t> equal_positions(std::span<const glm::vec3> positions) {
    std::vector<std::uint32_t> equal(positions.size());
    // A position's index, plus 1.
    std::vector<std::atomic<std::uint32_t>> table(
        std::bit_ceil(2 * std::max<std::size_t>(1, positions.size())));
    for_each_index(positions.size(), [&](std::size_t i) {
        const std::size_t mask = table.size() - 1;
        const auto fresh = static_cast<std::uint32_t>(i + 1);
        for (std::size_t slot = hash_of(positions[i]) & mask;; slot = (slot + 1) & mask) {
            std::uint32_t known = 0; // what is there, if it is not empty
            if (table[slot].compare_exchange_strong(known, fresh, std::memory_order_relaxed)) {
                equal[i] = fresh - 1;
                return;
            }
            if (positions[known - 1] != positions[i]) continue;
            equal[i] = known - 1;
            return;
        }
    });
    return equal;
}

} // namespace lineatlas
