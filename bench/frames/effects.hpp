#pragma once

#include <string_view>
#include <vector>

#include "report.hpp"
#include "row.hpp"

// The cost of a style's effects: frames of one scene with each effect alone and with all together.
namespace lineatlas::bench {

/// The row's name in the report.
inline constexpr std::string_view effects_row = "effects";

/// SAhi without effects ("none"), with each effect, and with all effects of strokes ("all").
std::vector<Drawn> effect_drawings();

/// The time of a frame with the effect `name` over that without effects; nothing if not measured.
std::optional<double> effect_cost(const Report& report, std::string_view name);

/// The effects that only change visible strokes, and "all". Hidden lines and fills, which draw
/// more, are not among them.
std::vector<std::string_view> stroke_effects();

} // namespace lineatlas::bench
