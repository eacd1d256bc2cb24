#include "atlas_layout.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "limits.hpp"

namespace lineatlas {

AtlasLayout make_atlas_layout(AtlasLayoutChoice choice, std::uint32_t longest,
                              std::uint32_t largest_row) {
    // Long rows waste less of a gutter; a power of two makes eq. 2 cheap.
    constexpr std::uint32_t usual_row = 8192;
    if (longest >= largest_row) {
        throw UsageError(beyond_limit(purpose::atlas,
                                      "rows of over " + std::to_string(longest) + " samples",
                                      "a row holds " + std::to_string(largest_row) + " here"));
    }
    const std::uint32_t wanted =
        std::max(usual_row, longest < (1U << 30U) ? std::bit_ceil(longest + 1) * 2 : largest_row);
    const std::uint32_t pitch = std::min(wanted, largest_row);
    return {.width = choice == AtlasLayoutChoice::wrap ? pitch : pitch - longest, .pitch = pitch};
}

} // namespace lineatlas
