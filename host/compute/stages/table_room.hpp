#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>

#include "core/limits.hpp"
#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// What a table gets that must hold `needed` bytes, or things of `size` bytes, and may have to grow
/// again soon: room for that where there is some.
inline std::uint64_t room_to_grow(const Device& device, std::uint64_t needed,
                                  std::size_t size = 1) {
    return with_room_to_grow(needed,
                             std::min(device.largest_buffer(), device.free_memory()) / size);
}

/// A first guess at how many elements a table must hold that can grow: no more than a buffer does.
template <class Element>
std::uint32_t first_capacity(const Device& device, std::uint32_t guess) {
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(guess, device.largest_buffer() / sizeof(Element)));
}

/// How many elements a table gets that must hold `needed` of them and may have to grow again.
template <class Element>
std::uint32_t capacity_for(const Device& device, std::uint32_t needed) {
    constexpr std::uint64_t most_counted = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(
        std::min(room_to_grow(device, needed, sizeof(Element)), most_counted));
}

/// As Device::allocate; the message of a Shortage says what the memory was for.
inline std::unique_ptr<Buffer> allocate(Device& device, std::size_t bytes, const Purpose& purpose) {
    return for_purpose(purpose, [&] { return device.allocate(bytes); });
}

} // namespace lineatlas::compute
