#pragma once

#include <set>

#include <imgui.h>

namespace lineatlas::viewer {

enum class Theme { light, dark };

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
