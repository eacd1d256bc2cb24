#include "colors.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

namespace lineatlas {
namespace {

// The colours of CSS, and sepia.
constexpr std::array<std::pair<std::string_view, std::uint32_t>, 21> names{{
    {"black", 0x000000},  {"white", 0xFFFFFF},  {"grey", 0x808080},   {"gray", 0x808080},
    {"silver", 0xC0C0C0}, {"red", 0xFF0000},    {"maroon", 0x800000}, {"brown", 0xA52A2A},
    {"orange", 0xFFA500}, {"yellow", 0xFFFF00}, {"gold", 0xFFD700},   {"olive", 0x808000},
    {"green", 0x008000},  {"lime", 0x00FF00},   {"teal", 0x008080},   {"cyan", 0x00FFFF},
    {"blue", 0x0000FF},   {"navy", 0x000080},   {"purple", 0x800080}, {"sepia", 0x5B3A1E},
    {"ivory", 0xFFFFF0},
}};

glm::vec3 from_rgb(std::uint32_t rgb) {
    const auto channel = [rgb](unsigned shift) {
        return static_cast<float>(rgb >> shift & 255U) / 255;
    };
    return {channel(16), channel(8), channel(0)};
}

} // namespace

std::optional<glm::vec3> parse_color(std::string_view text) {
    const auto found = std::ranges::find(names, text, [](const auto& n) { return n.first; });
    if (found != names.end()) return from_rgb(found->second);
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    std::uint32_t rgb{};
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
    if (error != std::errc{} || end != text.data() + 7) return std::nullopt;
    return from_rgb(rgb);
}

std::string hex_color(glm::vec3 color) {
    const auto byte = [](float c) { return std::lround(255 * std::clamp(c, 0.0F, 1.0F)); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(color.x), byte(color.y), byte(color.z));
}

} // namespace lineatlas
