// The list of commands that one searches by typing.
#include <algorithm>

#include "commands.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

/// Whether all words of a search stand in a name, in any order.
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

/// Draws a row. Returns whether it was clicked.
bool row(Ui& ui, const Command& command, bool chosen, bool scrolls_here) {
    const bool clicked = ImGui::Selectable(command.name, chosen);
    ui.spots.note(std::string{"command:"} + command.name);
    if (chosen && scrolls_here) ImGui::SetScrollHereY();
    const std::string key = key_text(command);
    ImGui::SameLine(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(key.c_str()).x);
    ImGui::TextDisabled("%s", key.c_str());
    return clicked;
}

void begin_palette(const Ui& ui, Area canvas, std::size_t rows) {
    const float height =
        static_cast<float>(std::max<std::size_t>(rows, 1)) * ImGui::GetTextLineHeightWithSpacing() +
        ui.points(64);
    const glm::vec2 room = canvas.size - ui.points(40);
    const glm::vec2 size =
        glm::min(room, glm::vec2{ui.points(440), std::min(height, ui.points(420))});
    const glm::vec2 upper_middle{0.5F * (canvas.size.x - size.x), ui.points(20)};
    begin_floating(ui, "palette", canvas.low + upper_middle, size, searched_flags);
}

} // namespace

void draw_palette(Ui& ui, Area canvas) {
    if (ui.panel != Panel::palette) return;
    SearchState& state = ui.palette;
    begin_palette(ui, canvas, found_by(state.searched).size());
    const bool entered = search_field(ui, state, "palette.search", "Type a command");
    const std::vector<const Command*> found = found_by(state.searched);
    const bool moved = move_choice(state, found.size());
    const auto chosen = static_cast<std::size_t>(state.chosen);
    const Command* taken = entered && !found.empty() ? found[chosen] : nullptr;
    ImGui::BeginChild("found", {}, false, searched_flags);
    for (std::size_t i = 0; i < found.size(); ++i)
        if (row(ui, *found[i], i == chosen, moved)) taken = found[i];
    if (found.empty()) ImGui::TextDisabled("There is no such command");
    ImGui::EndChild();
    ImGui::End();
    if (taken == nullptr) return;
    ui.panel = Panel::none;
    taken->run(ui);
}

} // namespace lineatlas::viewer
