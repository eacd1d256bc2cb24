#include <algorithm>

#include "core/pens.hpp"
#include "lineatlas/style_files.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

constexpr const char* plain_lines = "plain lines";

std::string shown_name(const std::string& style) {
    return style.empty() ? plain_lines : std::filesystem::path{style}.filename().string();
}

void style_list(Ui& ui) {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> result{""};
        for (const StyleInfo& info : list_styles()) result.push_back(info.name);
        return result;
    }();
    Session& session = ui.session;
    choice(
        ui, "style", "Style", shown_name(session.settings.style_name), names, shown_name,
        [&](const std::string& name) { return name == session.settings.style_name; },
        [&](const std::string& name) { session.use_style(name); },
        "Pens, widths, colours and effects together (N: the next one)");
}

bool mark(Ui& ui, Pen& pen) {
    bool changed = false;
    choice(
        ui, "pen", "Pen", shown_name(pen.mark), pen_names(),
        [](const PenName& name) { return std::string{name.name}; },
        [&](const PenName& name) { return name.name == pen.mark; },
        [&](const PenName& name) {
            pen.mark = name.name;
            changed = true;
        },
        "The mark that strokes leave");
    return changed;
}

bool color(Ui& ui, const char* id, const char* text, glm::vec3& value) {
    label(ui, text);
    return swatch(ui, id, value, "Colour of the lines");
}

bool fill(Ui& ui, Fill& fill) {
    struct Mode {
        FillMode mode;
        const char* name;
    };
    static constexpr std::array<Mode, 4> modes{{{FillMode::none, "none"},
                                                {FillMode::flat, "flat"},
                                                {FillMode::lambert, "lambert"},
                                                {FillMode::toon, "toon"}}};
    bool changed = false;
    choice(
        ui, "fill", "Fill", modes.at(static_cast<std::size_t>(fill.mode)).name, modes,
        [](const Mode& mode) { return std::string{mode.name}; },
        [&](const Mode& mode) { return mode.mode == fill.mode; },
        [&](const Mode& mode) {
            fill.mode = mode.mode;
            changed = true;
        },
        "Colour under the lines: even, shaded, or in a few tones");
    return changed;
}

bool pen_rows(Ui& ui, Style& style) {
    bool changed = mark(ui, style.pen);
    changed |= slider(ui, "width", "Width", style.pen.width, 0.3F, 12.0F, "%.1f px",
                      "Width of strokes in pixels");
    changed |= color(ui, "color", "Colour", style.pen.color);
    column(ui, 140);
    ImGui::TextUnformatted("Paper");
    column(ui, 188);
    return swatch(ui, "paper", style.paper.color, "Colour of the paper") || changed;
}

bool effect_rows(Ui& ui, Style& style) {
    StrokeFilter& filter = style.filter;
    bool changed = slider(ui, "overshoot", "Overshoot", filter.overshoot, 0.0F, 40.0F, "%.0f px",
                          "Strokes go on beyond their ends");
    changed |= slider(ui, "halo", "Halo", filter.halo, 0.0F, 20.0F, "%.1f px",
                      "Gap in the farther of two lines that cross");
    changed |= slider(ui, "density", "Density", style.density.limit, 0.0F, 1.0F,
                      style.density.limit > 0 ? "%.2f" : "no limit",
                      "How dense lines may be; less leaves some out");
    changed |= fill(ui, style.fill);
    changed |= slider(ui, "grain", "Grain", style.paper.grain, 0.0F, 1.0F, "%.2f",
                      "Strength of the texture of the paper");
    changed |= checkbox(ui, "hidden", "Hidden lines", style.hidden);
    tip(ui, "Lines behind faces, in a pen of their own (H)");
    if (!style.hidden) return changed;
    changed |= slider(ui, "hidden-width", "  their width", style.hidden_pen.width, 0.3F, 6.0F,
                      "%.1f px", "Width of hidden lines");
    changed |= color(ui, "hidden-color", "  their colour", style.hidden_pen.color);
    changed |=
        slider(ui, "hidden-density", "  their density", style.hidden_density, 0.0F, 1.0F,
               style.hidden_density > 0 ? "%.2f" : "no limit", "How dense hidden lines may be");
    return changed;
}

} // namespace

void draw_style_section(Ui& ui) {
    if (!section(ui, "style", "Style")) return;
    style_list(ui);
    Style& style = ui.session.settings.style;
    const bool pen_changed = pen_rows(ui, style);
    const bool effect_changed = effect_rows(ui, style);
    if (pen_changed || effect_changed) ui.session.changed();
    if (button(ui, "save.style", "Save the style", -1)) save_as(ui, SavedKind::style);
    tip(ui, "As TOML, for --style");
}

} // namespace lineatlas::viewer
