#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace lineatlas {

/// The `size` bytes (1 to 8) at `place` as one number, whatever the machine's own order is.
inline std::uint64_t read_bytes(std::string_view bytes, std::size_t place, std::size_t size,
                                bool big_endian = false) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t at = place + (big_endian ? i : size - 1 - i);
        value = value << 8U | static_cast<unsigned char>(bytes[at]);
    }
    return value;
}

inline std::uint32_t read_u32(std::string_view bytes, std::size_t place) {
    return static_cast<std::uint32_t>(read_bytes(bytes, place, 4));
}

inline float read_f32(std::string_view bytes, std::size_t place) {
    return std::bit_cast<float>(read_u32(bytes, place));
}

} // namespace lineatlas
