#pragma once

#include <imgui.h>

namespace lineatlas::viewer {

enum class Theme { light, dark };

namespace theme {
/// Paper, ink and one blue.
struct Colors {
    ImU32 ink, quiet, accent, line, panel, alarm;
};
/// Of the theme that was applied last.
const Colors& colors();
} // namespace theme

/// Dark where the desktop says so (GTK_THEME).
Theme theme_of_desktop();

/// Letters and spacing for letters `scale` times the usual size, on a display of so many pixels per
/// point. `bold`: of headings.
ImFont* apply_theme(Theme theme, float scale, float pixels_per_point);

} // namespace lineatlas::viewer
