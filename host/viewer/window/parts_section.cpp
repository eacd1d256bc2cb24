#include <algorithm>

#include <fmt/format.h>
#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include "viewer/kind_pens.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

/// What the list shows: parts of that name, or the tree as far as it is not folded.
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
    HiddenParts hidden = ui.session.settings.shown.hidden;
    bool shown = !hidden.contains(part);
    const std::uint32_t above = parts.all()[part].parent;
    ImGui::BeginDisabled(above != Parts::none && parts.is_hidden(above, hidden));
    const bool pressed = ImGui::Checkbox("##shown", &shown);
    ui.spots.note("show:" + name);
    ImGui::EndDisabled();
    ImGui::SameLine(0, ui.points(6));
    if (!pressed) return;
    if (shown)
        hidden.erase(part);
    else
        hidden.insert(part);
    ui.session.hide_parts(std::move(hidden));
}

void row(Ui& ui, const Parts& parts, std::uint32_t part) {
    const Parts::Part& shown = parts.all()[part];
    ImGui::PushID(static_cast<int>(part));
    const std::uint32_t depth = ui.part_search.empty() ? shown.depth : 0;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.points(14) * static_cast<float>(depth));
    if (shown.holds_others && ui.part_search.empty()) arrow(ui, part);
    eye(ui, parts, part, shown.name);
    if (ImGui::Selectable(shown.name.c_str(), ui.session.selected == part,
                          ImGuiSelectableFlags_AllowDoubleClick)) {
        ui.session.selected = part;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) ui.session.frame_part(part);
    }
    ui.spots.note("part:" + shown.name);
    tip(parts.path_of(part).c_str());
    ImGui::PopID();
}

void buttons(Ui& ui) {
    Session& session = ui.session;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    ImGui::BeginDisabled(!session.selected);
    if (button(ui, "parts.isolate", "Isolate", third))
        session.hide_parts(session.model()->parts.all_but(*session.selected));
    tip("Hide all but the selected part (I); Delete hides it");
    ImGui::SameLine(0, gap);
    if (button(ui, "parts.frame", "Frame", third)) session.frame_part(*session.selected);
    ImGui::EndDisabled();
    ImGui::SameLine(0, gap);
    ImGui::BeginDisabled(session.settings.shown.hidden.empty());
    if (button(ui, "parts.all", "Show all", third)) session.hide_parts({});
    tip("Show what is hidden (U)");
    ImGui::EndDisabled();
}

/// Width and colour of the selected part's lines.
void pen(Ui& ui, const Parts& parts) {
    if (!ui.session.selected) return;
    const std::vector<std::string> objects = parts.objects_of(*ui.session.selected);
    constexpr std::size_t most = 64; // each is a rule of the style
    if (objects.empty() || objects.front().empty() || objects.size() > most) return;
    Style& style = ui.session.settings.style;
    Pen pen = pen_of_object(style, objects.front());
    label(ui, "Its lines");
    const float room = ImGui::GetContentRegionAvail().x / ui.scale - 32;
    const bool wider =
        slider_with_number(ui, "part.width", pen.width, 0.3F, 12.0F, "%.1f px", room, 64);
    ImGui::SameLine(0, ui.points(8));
    const bool other = swatch(ui, "part.color", pen.color);
    for (const std::string& object : objects) {
        if (wider) set_width_of_object(style, object, pen.width);
        if (other) set_color_of_object(style, object, pen.color);
    }
    if (wider || other) ui.session.changed();
}

} // namespace

void draw_parts_section(Ui& ui) {
    const Model* model = ui.session.model();
    if (model == nullptr || model->parts.all().empty()) return;
    if (!section(ui, "parts", fmt::format("{} parts", model->parts.all().size()).c_str())) return;
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", "Search", &ui.part_search);
    ui.spots.note("parts.search");
    const std::vector<std::uint32_t> listed = rows(ui, model->parts);
    constexpr std::size_t most = 8;
    const float height = ImGui::GetFrameHeightWithSpacing() *
                         static_cast<float>(std::clamp<std::size_t>(listed.size(), 1, most));
    ImGui::BeginChild("parts.list", {0, height}, false, ImGuiWindowFlags_NavFlattened);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(listed.size()), ImGui::GetFrameHeightWithSpacing());
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            row(ui, model->parts, listed[static_cast<std::size_t>(i)]);
    }
    if (listed.empty()) ImGui::TextDisabled("No part is called so");
    ImGui::EndChild();
    buttons(ui);
    pen(ui, model->parts);
}

} // namespace lineatlas::viewer
