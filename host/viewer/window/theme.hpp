#pragma once

#include <imgui.h>

namespace lineatlas::viewer {

/// Paper, ink and one blue.
namespace theme {
inline constexpr ImU32 ink = IM_COL32(38, 40, 44, 255);
inline constexpr ImU32 quiet = IM_COL32(120, 122, 128, 255);
inline constexpr ImU32 accent = IM_COL32(44, 98, 158, 255);
inline constexpr ImU32 line = IM_COL32(222, 220, 214, 255);
inline constexpr ImU32 panel = IM_COL32(248, 247, 244, 255);
inline constexpr ImU32 alarm = IM_COL32(176, 48, 40, 255);
} // namespace theme

/// Letters and spacing for letters `scale` times the usual size, on a display of so many pixels per
/// point. `bold`: of headings.
ImFont* apply_theme(float scale, float pixels_per_point);

} // namespace lineatlas::viewer
