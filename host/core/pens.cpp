#include "pens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr std::array<std::string_view, 4> names{"solid", "pen", "pencil", "dashed"};

std::uint32_t hash(std::uint32_t x, std::uint32_t y) {
    std::uint32_t h = x * 0x9E3779B1U ^ y * 0x85EBCA77U;
    h ^= h >> 15U;
    h *= 0x2C1B3C6DU;
    h ^= h >> 12U;
    h *= 0x297A2D39U;
    return h ^ h >> 15U;
}

float random_unit(int x, int y) {
    return static_cast<float>(hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))) /
           4294967296.0F;
}

/// Smooth noise in [0, 1) with features of size 1, repeating after `period` along x.
float value_noise(float x, float y, int period) {
    const float fx = std::floor(x);
    const float fy = std::floor(y);
    const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
    const float tx = smooth(x - fx);
    const float ty = smooth(y - fy);
    const auto at = [&](int dx, int dy) {
        const int column = (static_cast<int>(fx) + dx) % period;
        return random_unit(column < 0 ? column + period : column, static_cast<int>(fy) + dy);
    };
    return std::lerp(std::lerp(at(0, 0), at(1, 0), tx), std::lerp(at(0, 1), at(1, 1), tx), ty);
}

/// Pixels after which grain and unevenness repeat; a multiple of every feature size below.
constexpr int repeat = 512;

/// A texture whose columns are `columns` screen pixels, filled by coverage(x, v): x in pixels along
/// the stroke, v from -1 to 1 across it.
template <class Coverage>
PenMark paint(int columns, int rows, Coverage&& coverage) {
    PenMark mark{
        .size = {columns, rows}, .coverage = {}, .repeat_length = static_cast<float>(columns)};
    for (int row = 0; row < rows; ++row) {
        const float v = (static_cast<float>(row) + 0.5F) / static_cast<float>(rows) * 2 - 1;
        for (int column = 0; column < columns; ++column) {
            const float c = std::clamp(coverage(static_cast<float>(column) + 0.5F, v), 0.0F, 1.0F);
            mark.coverage.push_back(static_cast<std::uint8_t>(std::lround(255 * c)));
        }
    }
    return mark;
}

/// Ink that flows unevenly: the edge wanders slowly by a fraction of the width.
float ink(float x, float v) {
    const float left = 0.74F + 0.26F * value_noise(x / 8, 1, repeat / 8);
    const float right = 0.74F + 0.26F * value_noise(x / 8, 40, repeat / 8);
    return (v < 0 ? left - std::abs(v) : right - std::abs(v)) * 6;
}

/// Graphite: paper grain that takes more or less of it, pressure that varies, a soft edge.
float graphite(float x, float v, float width) {
    const float grain = value_noise(x / 1.6F, (v + 1) * width / 3.2F + 7, repeat * 10 / 16);
    const float pressure = 0.65F + 0.35F * value_noise(x / 32, 90, repeat / 32);
    const float edge = 1 - std::pow(std::abs(v), 3.0F);
    return edge * pressure * (0.35F + 0.9F * grain);
}

} // namespace

std::span<const std::string_view> pen_names() {
    return names;
}

PenMark make_pen(std::string_view name, float width) {
    constexpr int rows = 16;
    if (name == "solid") return {};
    if (name == "pen") return paint(repeat, rows, ink);
    if (name == "pencil") {
        return paint(repeat, rows, [&](float x, float v) { return graphite(x, v, width); });
    }
    if (name == "dashed") {
        // Dash and gap grow with the width, so that the pattern keeps its look.
        const int dash = std::max(4, static_cast<int>(std::lround(6 * width)));
        const int gap = std::max(3, static_cast<int>(std::lround(3 * width)));
        return paint(dash + gap, 1,
                     [&](float x, float) { return x < static_cast<float>(dash) ? 1.0F : 0.0F; });
    }
    std::string known;
    for (const std::string_view pen : names)
        known += (known.empty() ? "" : ", ") + std::string{pen};
    throw UsageError("unknown pen \"" + std::string{name} + "\"; there is " + known);
}

} // namespace lineatlas
