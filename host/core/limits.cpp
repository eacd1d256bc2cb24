#include "limits.hpp"

#include <array>
#include <cstdio>

namespace lineatlas {

std::string beyond_limit(const Purpose& purpose, std::string_view needed,
                         std::string_view available) {
    std::string message{purpose.what};
    message.append(" needs ").append(needed).append(", and ").append(available);
    return message.append("; ").append(purpose.help);
}

Shortage::Shortage(std::string needed, std::string available)
    : OutOfMemory(purpose::scratch, needed, available), needed_(std::move(needed)),
      available_(std::move(available)) {}

OutOfMemory Shortage::of(const Purpose& purpose) const {
    return {purpose, needed_, available_};
}

std::string written_bytes(std::uint64_t bytes) {
    constexpr std::array<const char*, 5> units{"bytes", "KiB", "MiB", "GiB", "TiB"};
    if (bytes < 1024) return std::to_string(bytes) + " bytes";
    auto value = static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; value >= 1024 && unit + 1 < units.size(); ++unit) value /= 1024;
    std::array<char, 32> text{};
    const int digits = value < 10 ? 2 : value < 100 ? 1 : 0;
    std::snprintf(text.data(), text.size(), "%.*f %s", digits, value, units[unit]);
    return text.data();
}

std::string written_size(glm::ivec2 size) {
    return std::to_string(size.x) + "x" + std::to_string(size.y);
}

} // namespace lineatlas
