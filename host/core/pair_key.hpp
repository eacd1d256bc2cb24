#pragma once

#include <algorithm>
#include <cstdint>

namespace lineatlas {

/// A number for two of a kind in either order: the ends of an edge, two triangles.
inline std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
}

} // namespace lineatlas
