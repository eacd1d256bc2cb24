#include "scan.hpp"

#include <algorithm>
#include <limits>

namespace lineatlas::test::oracles {

void scan(std::span<std::uint32_t> values, compute::ScanKind kind) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::uint32_t value = i + 1 < values.size() ? values[i] : 0;
        values[i] = static_cast<std::uint32_t>(sum);
        sum += value;
        if (kind == compute::ScanKind::saturate) {
            sum = std::min<std::uint64_t>(sum, std::numeric_limits<std::uint32_t>::max());
        }
    }
}

} // namespace lineatlas::test::oracles
