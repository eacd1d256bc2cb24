#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include "viewer/kind_pens.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

constexpr const char* menu_name = "parts.menu";

/// The parts in the list: those that match the search, or the tree as far as it is not folded.
std::vector<std::uint32_t> rows(const Ui& ui, const Parts& parts) {
    std::vector<std::uint32_t> result;
    const std::vector<Parts::Part>& all = parts.all();
    for (std::uint32_t part = 0; part < all.size(); ++part) {
        bool listed = contains(all[part].name, ui.part_search);
        for (std::uint32_t above = all[part].parent; ui.part_search.empty() && above != Parts::none;
             above = all[above].parent)
            listed = listed && !ui.folded_parts.contains(above);
        if (listed) result.push_back(part);
    }
    return result;
}

void arrow(Ui& ui, std::uint32_t part) {
    const bool folded = ui.folded_parts.contains(part);
    if (ImGui::ArrowButton("##fold", folded ? ImGuiDir_Right : ImGuiDir_Down)) {
        if (folded)
            ui.folded_parts.erase(part);
        else
            ui.folded_parts.insert(part);
    }
    ImGui::SameLine(0, ui.points(4));
}

void eye(Ui& ui, const Parts& parts, std::uint32_t part, const std::string& name) {
    ShownParts all = ui.session.settings.shown.parts;
    bool shown = parts.is_shown(part, all);
    const std::uint32_t above = parts.all()[part].parent;
    ImGui::BeginDisabled(above != Parts::none && parts.is_among(above, all.hidden));
    const bool pressed = ImGui::Checkbox("##shown", &shown);
    ui.spots.note("show:" + name);
    tip(ui, "Show or hide this part");
    ImGui::EndDisabled();
    ImGui::SameLine(0, ui.points(6));
    if (!pressed) return;
    if (!shown) {
        all.hidden.insert(part);
    } else {
        all.hidden.erase(part);
        if (!all.only.empty() && !parts.is_among(part, all.only)) all.only.insert(part);
    }
    ui.session.show_parts(std::move(all));
}

/// Selects rows as other lists do: a click selects one, with Ctrl one more, with Shift all from the
/// last one clicked.
void select_row(Ui& ui, const std::vector<std::uint32_t>& listed, std::size_t row) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto anchor = std::ranges::find(listed, ui.part_anchor);
    if (!io.KeyShift || anchor == listed.end()) {
        ui.part_anchor = listed[row];
        return ui.session.select(listed[row], io.KeyCtrl);
    }
    const auto from = static_cast<std::size_t>(anchor - listed.begin());
    ui.session.selected.clear();
    for (std::size_t i = std::min(from, row); i <= std::max(from, row); ++i)
        ui.session.selected.insert(listed[i]);
}

void row(Ui& ui, const Parts& parts, const std::vector<std::uint32_t>& listed, std::size_t at) {
    const std::uint32_t part = listed[at];
    const Parts::Part& shown = parts.all()[part];
    ImGui::PushID(static_cast<int>(part));
    const std::uint32_t depth = ui.part_search.empty() ? shown.depth : 0;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.points(14) * static_cast<float>(depth));
    if (shown.holds_others && ui.part_search.empty()) arrow(ui, part);
    eye(ui, parts, part, shown.name);
    viewer::shown(ui, parts.path_of(part));
    if (ImGui::Selectable(shown.name.c_str(), ui.session.selected.contains(part),
                          ImGuiSelectableFlags_AllowDoubleClick)) {
        select_row(ui, listed, at);
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) ui.session.frame_selected();
    }
    ui.spots.note("part:" + shown.name);
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        if (!ui.session.selected.contains(part)) ui.session.select(part);
        ui.opens_menu = true;
    }
    tip(ui, parts.path_of(part).c_str());
    ImGui::PopID();
}

void buttons(Ui& ui) {
    Session& session = ui.session;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    ImGui::BeginDisabled(session.selected.empty());
    if (button(ui, "parts.isolate", "Isolate", third)) session.isolate_selected();
    tip(ui, "Show what is selected alone (I); Delete hides it");
    ImGui::SameLine(0, gap);
    if (button(ui, "parts.frame", "Frame", third)) session.frame_selected();
    tip(ui, "Fill the picture with what is selected (Shift + F)");
    ImGui::EndDisabled();
    ImGui::SameLine(0, gap);
    ImGui::BeginDisabled(session.settings.shown.parts == ShownParts{});
    if (button(ui, "parts.all", "Show all", third)) session.show_parts({});
    tip(ui, "Show what is hidden (U)");
    ImGui::EndDisabled();
}

/// Draws width and colour of the selected parts' lines.
void pen(Ui& ui, const Parts& parts) {
    std::vector<std::string> objects;
    for (const std::uint32_t part : ui.session.selected)
        std::ranges::copy(parts.objects_of(part), std::back_inserter(objects));
    constexpr std::size_t most = 64; // each object is a rule of the style
    if (objects.empty() || objects.front().empty() || objects.size() > most) return;
    Style& style = ui.session.settings.style;
    Pen pen = pen_of_object(style, objects.front());
    label(ui, "Its lines");
    const float room = ImGui::GetContentRegionAvail().x / ui.scale - 32;
    const bool wider = slider_with_number(ui, "part.width", pen.width, 0.3F, 12.0F, "%.1f px", room,
                                          measures::number_room);
    tip(ui, "Width of its lines in pixels");
    ImGui::SameLine(0, ui.points(8));
    const bool other = swatch(ui, "part.color", pen.color, "Colour of its lines");
    for (const std::string& object : objects) {
        if (wider) set_width_of_object(style, object, pen.width);
        if (other) set_color_of_object(style, object, pen.color);
    }
    if (wider || other) ui.session.changed();
}

/// The height of the list: as it was dragged, or that of its rows.
float list_height(const Ui& ui, std::size_t rows) {
    constexpr std::size_t most = 8;
    const float row = ImGui::GetFrameHeightWithSpacing();
    if (ui.parts_height > 0) return std::max(ui.points(ui.parts_height), row);
    return row * static_cast<float>(std::clamp<std::size_t>(rows, 1, most));
}

/// Draws a bar that makes the list higher or lower.
void divider(Ui& ui, float height) {
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::InvisibleButton("parts.divider", {width, ui.points(measures::gap)});
    ui.spots.note("parts.divider");
    const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    tip(ui, "Drag to show more or fewer parts");
    if (hovered || held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float y = 0.5F * (low.y + high.y), middle = 0.5F * (low.x + high.x);
    const float half = ui.points(16);
    ImGui::GetWindowDrawList()->AddLine(
        {middle - half, y}, {middle + half, y},
        held || hovered ? theme::colors().accent : theme::colors().quiet, ui.points(2));
    if (held && ImGui::GetIO().MouseDelta.y != 0)
        ui.parts_height = (height + ImGui::GetIO().MouseDelta.y) / ui.scale;
}

} // namespace

void draw_parts_menu(Ui& ui) {
    if (std::exchange(ui.opens_menu, false)) ImGui::OpenPopup(menu_name);
    if (!ImGui::BeginPopup(menu_name)) return;
    Session& session = ui.session;
    const auto item = [&](const char* text, const char* key, bool possible = true) {
        const bool chosen = ImGui::MenuItem(text, key, false, possible);
        ui.spots.note(std::string{"menu:"} + text);
        return chosen;
    };
    if (session.model() != nullptr && !session.selected.empty()) {
        const Parts& parts = session.model()->parts;
        const std::uint32_t first = *session.selected.begin();
        const std::uint32_t above = parts.all()[first].parent;
        ImGui::TextDisabled("%s", session.selected.size() == 1
                                      ? parts.all()[first].name.c_str()
                                      : fmt::format("{} parts", session.selected.size()).c_str());
        if (item("Show alone", "I")) session.isolate_selected();
        if (item("Hide", "Delete")) session.hide_selected();
        if (item("Frame", "Shift + F")) session.frame_selected();
        if (item("Select the part around it", "", above != Parts::none)) session.select(above);
        if (item("Copy the name", "")) ImGui::SetClipboardText(parts.path_of(first).c_str());
        ImGui::Separator();
    }
    if (item("Show all", "U", session.settings.shown.parts != ShownParts{})) session.show_parts({});
    if (item("Fit the model", "F")) session.fit();
    if (item("Add a section", "C")) session.add_cut();
    if (item("Export ...", "Ctrl + E")) switch_panel(ui, Panel::exporting);
    ImGui::EndPopup();
}

void draw_parts_section(Ui& ui) {
    const Model* model = ui.session.model();
    if (model == nullptr || model->parts.all().empty()) return;
    if (!section(ui, "parts", fmt::format("{} parts", model->parts.all().size()).c_str())) return;
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", "Search", &ui.part_search);
    shown(ui, ui.part_search); // letters that were pasted
    ui.spots.note("parts.search");
    tip(ui, "Parts with these letters in their names");
    const std::vector<std::uint32_t> listed = rows(ui, model->parts);
    const float height = list_height(ui, listed.size());
    ImGui::BeginChild("parts.list", {0, height}, false, ImGuiWindowFlags_NavFlattened);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(listed.size()), ImGui::GetFrameHeightWithSpacing());
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            row(ui, model->parts, listed, static_cast<std::size_t>(i));
    }
    if (listed.empty()) ImGui::TextDisabled("There is no such part");
    ImGui::EndChild();
    divider(ui, height);
    buttons(ui);
    pen(ui, model->parts);
}

} // namespace lineatlas::viewer
