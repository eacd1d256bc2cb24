#pragma once

#include <set>

#include <imgui.h>

namespace lineatlas::viewer {

enum class Theme { light, dark };

/// Sizes and gaps of the whole window, in points; what is smaller is a half or a quarter of a gap.
namespace measures {
inline constexpr float letters = 15;       ///< headings, too: those are bold
inline constexpr float gap = 8;            ///< between items
inline constexpr float sidebar = 312;      ///< its width
inline constexpr float label_column = 96;  ///< where what a label is about begins
inline constexpr float number_room = 64;   ///< right of a slider
inline constexpr float tip = 320;          ///< width of what says what an item does
inline constexpr float inset = 12;         ///< of what floats, from the picture's border
inline constexpr float panel_rounding = 6; ///< of what floats
inline constexpr float item_rounding = 4;  ///< of buttons, fields and plates
inline constexpr struct { float x, y; } progress{260, 4}; ///< the bar
} // namespace measures

namespace theme {
/// Paper, ink and one accent: a dark one with light letters on it. What is marked in the picture
/// has hues of its own.
struct Colors {
    ImU32 ink, quiet, accent, on_accent, line, panel, alarm;
    ImU32 selection, section, measure;
};
/// Of the theme that was applied last.
const Colors& colors();
} // namespace theme

/// Dark where the desktop says so (GTK_THEME).
Theme theme_of_desktop();

/// Fonts have all letters up to this one (Latin-1), others as they are needed: those of all
/// languages would take tens of MB.
inline constexpr unsigned last_usual_letter = 0xFF;
/// Letters beyond it, as Unicode has them.
using Letters = std::set<unsigned>;

/// Letters and spacing for letters `scale` times the usual size, on a display of so many pixels per
/// point. Returns the font of headings. A letter that no font of this machine has is a "?".
ImFont* apply_theme(Theme theme, float scale, float pixels_per_point, const Letters& letters);

} // namespace lineatlas::viewer
