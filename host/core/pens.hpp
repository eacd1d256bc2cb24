#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace lineatlas {

/// A pen's mark: coverage from 0 to 255, rows across the stroke, columns along it; repeats along.
struct PenMark {
    glm::ivec2 size{0, 0}; ///< 0: a solid mark
    std::vector<std::uint8_t> coverage;
    float repeat_length = 1; ///< pixels on the screen that one repeat covers
};

/// The names `make_pen` knows.
std::span<const std::string_view> pen_names();

/// A built-in pen: solid, pen (slightly uneven ink), pencil (graphite on paper grain) or dashed.
/// `width` is the stroke's width in pixels; grain keeps its size on the screen whatever the width.
/// Throws UsageError for an unknown name.
PenMark make_pen(std::string_view name, float width);

} // namespace lineatlas
