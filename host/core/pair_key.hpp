#pragma once

#include <algorithm>
#include <cstdint>

namespace lineatlas {

/// A number for a pair in either order, such as the ends of an edge or two triangles.
inline std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
}

} // namespace lineatlas
