#pragma once

#include <cstdint>

namespace lineatlas::compute {

constexpr std::uint32_t divide_up(std::uint32_t n, std::uint32_t by) {
    return n / by + (n % by != 0 ? 1 : 0);
}

} // namespace lineatlas::compute
