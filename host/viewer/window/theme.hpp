#pragma once

#include <set>

#include <imgui.h>

namespace lineatlas::viewer {

enum class Theme { light, dark };

/// Sizes and gaps of the whole window, in points. Smaller gaps are a half or a quarter of `gap`.
namespace measures {
inline constexpr float letters = 15;       ///< also of headings, which are bold
inline constexpr float gap = 8;            ///< between items
inline constexpr float sidebar = 312;      ///< width of the sidebar
inline constexpr float tool_bar = 40;      ///< height of the bar above the picture
inline constexpr float label_column = 96;  ///< where the value beside a label begins
inline constexpr float number_room = 64;   ///< right of a slider
inline constexpr float tip = 320;          ///< width of a tip
inline constexpr float inset = 12;         ///< of floating panels from the picture's border
inline constexpr float panel_rounding = 6; ///< of floating panels
inline constexpr float item_rounding = 4;  ///< of buttons, fields and plates
inline constexpr struct { float x, y; } progress{260, 4}; ///< the size of the bar
} // namespace measures

namespace theme {
/// Paper, ink and one accent, which is dark with light letters on it. Marks in the picture have
/// hues of their own.
struct Colors {
    ImU32 ink, quiet, accent, on_accent, line, panel, alarm;
    ImU32 selection, section, measure;
};
/// The colours of the theme that was applied last.
const Colors& colors();
} // namespace theme

/// The theme of the desktop: dark if GTK_THEME says so.
Theme theme_of_desktop();

/// Fonts have all letters up to this one (Latin-1) and others when they are needed. The letters of
/// all languages would take tens of MB.
inline constexpr unsigned last_usual_letter = 0xFF;
/// Letters beyond it, as Unicode code points.
using Letters = std::set<unsigned>;

/// Applies a theme with letters and spacing of `scale` times the usual size, on a display with
/// `pixels_per_point`. Returns the font of headings. A letter that no font of this machine has
/// becomes "?".
ImFont* apply_theme(Theme theme, float scale, float pixels_per_point, const Letters& letters);

} // namespace lineatlas::viewer
