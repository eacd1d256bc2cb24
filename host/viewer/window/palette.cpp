// The list of commands that one searches by typing.
#include <algorithm>

#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include "commands.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

/// All words of the search stand in the name, in any order.
bool matches(const std::string& name, const std::string& searched) {
    for (std::size_t at = 0; at < searched.size();) {
        const std::size_t end = std::min(searched.find(' ', at), searched.size());
        if (!contains(name, searched.substr(at, end - at))) return false;
        at = end + 1;
    }
    return true;
}

std::vector<const Command*> found_by(const std::string& searched) {
    std::vector<const Command*> found;
    for (const Command& command : commands())
        if (matches(command.name, searched)) found.push_back(&command);
    return found;
}

void move_choice(int& chosen, int count) {
    if (ImGui::IsKeyPressed(ImGuiKey_DownArrow)) ++chosen;
    if (ImGui::IsKeyPressed(ImGuiKey_UpArrow)) --chosen;
    chosen = std::clamp(chosen, 0, std::max(count - 1, 0));
}

} // namespace

void show_palette(Ui& ui) {
    ui.palette = PaletteState{};
}

void draw_palette(Ui& ui, Area canvas) {
    if (!ui.palette) return;
    PaletteState& state = *ui.palette;
    const std::vector<const Command*> found = found_by(state.searched);
    const float rows = static_cast<float>(std::max<std::size_t>(found.size(), 1)) *
                           ImGui::GetTextLineHeightWithSpacing() +
                       ui.points(64);
    const glm::vec2 room = canvas.size - ui.points(40) - glm::vec2{0, ui.points(40)};
    const glm::vec2 size =
        glm::min(room, glm::vec2{ui.points(440), std::min(rows, ui.points(420))});
    const glm::vec2 below_the_bar{0.5F * (canvas.size.x - size.x), ui.points(60)};
    begin_floating(ui, "palette", canvas.low + below_the_bar, size);
    ImGui::SetNextItemWidth(-1);
    if (!std::exchange(state.has_keyboard, true)) ImGui::SetKeyboardFocusHere();
    const std::string before = state.searched;
    const bool entered = ImGui::InputTextWithHint(
        "##searched", "What is to be done?", &state.searched, ImGuiInputTextFlags_EnterReturnsTrue);
    ui.spots.note("palette.search");
    if (before != state.searched) state.chosen = 0;
    const int last = state.chosen;
    move_choice(state.chosen, static_cast<int>(found.size()));
    const Command* taken = nullptr;
    ImGui::BeginChild("found");
    for (int i = 0; i < static_cast<int>(found.size()); ++i) {
        const Command& command = *found[static_cast<std::size_t>(i)];
        if (ImGui::Selectable(command.name, i == state.chosen)) taken = &command;
        ui.spots.note(std::string{"command:"} + command.name);
        if (i == state.chosen && last != state.chosen) ImGui::SetScrollHereY();
        const std::string key = key_text(command);
        ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(key.c_str()).x);
        ImGui::TextDisabled("%s", key.c_str());
    }
    if (found.empty()) ImGui::TextDisabled("No command is called so");
    ImGui::EndChild();
    ImGui::End();
    if (entered && !found.empty()) taken = found[static_cast<std::size_t>(state.chosen)];
    if (taken != nullptr) ui.palette.reset();
    if (taken != nullptr) taken->run(ui);
}

} // namespace lineatlas::viewer
