#pragma once

#include <string_view>
#include <vector>

#include "report.hpp"
#include "row.hpp"

// What the effects of a style cost: frames of one scene with each of them alone, and together.
namespace lineatlas::bench {

/// The row's name in the report.
inline constexpr std::string_view effects_row = "effects";

/// SAhi without any effect ("none"), with each, and with all that change strokes ("all").
std::vector<Drawn> effect_drawings();

/// The frame with `name` over the frame without effects; nothing if not measured.
std::optional<double> effect_cost(const Report& report, std::string_view name);

/// Those that change visible strokes alone, and "all" of them; hidden lines and fills draw more.
std::vector<std::string_view> stroke_effects();

} // namespace lineatlas::bench
