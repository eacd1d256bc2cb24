#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "theme.hpp"
#include "ui.hpp"

// Rows of a panel: a label on the left, its value on the right. All return whether the value has
// changed, and are noted under their id.
namespace lineatlas::viewer {

/// A text that may have any letters. Fonts have them from the next frame on.
inline const char* shown(Ui& ui, const std::string& text) {
    for (const char *at = text.c_str(), *end = at + text.size(); at < end;) {
        unsigned letter = 0;
        at += ImTextCharFromUtf8(&letter, at, end);
        if (letter > last_usual_letter) ui.letters.insert(letter);
    }
    return text.c_str();
}

inline void heading(const Ui& ui, const char* text) {
    ImGui::Dummy({0, ui.points(2)});
    ImGui::PushFont(ui.bold);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

/// Whether a text is in another, whatever the case of their letters.
inline bool contains(const std::string& text, const std::string& searched) {
    const auto equal = [](unsigned char a, unsigned char b) {
        return std::tolower(a) == std::tolower(b);
    };
    return std::search(text.begin(), text.end(), searched.begin(), searched.end(), equal) !=
               text.end() ||
           searched.empty();
}

/// Flags of an InvisibleButton that keys can reach. Newer versions of ImGui skip others.
#if IMGUI_VERSION_NUM >= 19200
inline constexpr ImGuiButtonFlags by_keys = ImGuiButtonFlags_EnableNav;
#else
inline constexpr ImGuiButtonFlags by_keys = ImGuiButtonFlags_None;
#endif

/// A heading. A click folds or opens the rows below it. Returns whether they are open.
inline bool section(Ui& ui, const char* id, const char* text) {
    ImGui::Dummy({0, ui.points(2)});
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
    if (ImGui::InvisibleButton(id, {width, height}, by_keys)) {
        if (ui.folded.erase(id) == 0) ui.folded.insert(id);
    }
    ui.spots.note(std::string{"section:"} + id);
    const bool open = !ui.folded.contains(id);
    const ImU32 color = ImGui::IsItemHovered() ? theme::colors().accent : theme::colors().ink;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(ui.bold, ImGui::GetFontSize(), low, color, text);
    const float half = ui.points(4), x = low.x + width - 2 * half, y = low.y + 0.5F * height;
    if (open)
        list.AddTriangleFilled({x - half, y - half / 2}, {x + half, y - half / 2},
                               {x, y + half / 2}, theme::colors().quiet);
    else
        list.AddTriangleFilled({x - half / 2, y - half}, {x + half / 2, y},
                               {x - half / 2, y + half}, theme::colors().quiet);
    return open;
}

/// Goes on in the same row, `points` from its start.
inline void column(const Ui& ui, float points) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMin().x + ui.points(points));
}

inline void label(const Ui& ui, const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    column(ui, measures::label_column);
    ImGui::SetNextItemWidth(-1);
}

/// A tip that says what the last item does.
inline void tip(Ui& ui, const char* text) {
    ui.spots.note_tip();
    if (ImGui::IsItemActive()) return; // a tip would cover what is found while one types
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const std::string whole = text;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ui.points(measures::tip));
    ImGui::TextUnformatted(shown(ui, whole));
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// A slider of a width in points, 0 for all the room there is. Its number stands on the right, in
/// `room` points that the grip never covers. Ctrl and a click lets one type the number.
template <class Number>
bool slider_with_number(Ui& ui, const std::string& id, Number& value, Number low, Number high,
                        const char* format, float width, float room) {
    constexpr ImGuiDataType type = std::is_same_v<Number, float>    ? ImGuiDataType_Float
                                   : std::is_same_v<Number, double> ? ImGuiDataType_Double
                                                                    : ImGuiDataType_S32;
    const std::string name = "##" + id;
    const float all = width > 0 ? ui.points(width) : ImGui::GetContentRegionAvail().x;
    ImGui::BeginGroup(); // one item
    ImGui::SetNextItemWidth(all - ui.points(room));
    const bool typed = ImGui::TempInputIsActive(ImGui::GetID(name.c_str()));
    if (!typed) ImGui::PushStyleColor(ImGuiCol_Text, 0); // the number that lies under the grip
    const bool changed = ImGui::SliderScalar(name.c_str(), type, &value, &low, &high, format,
                                             ImGuiSliderFlags_AlwaysClamp);
    if (!typed) ImGui::PopStyleColor();
    ui.spots.note(id);
    std::array<char, 64> text{};
    ImGui::DataTypeFormatString(text.data(), static_cast<int>(text.size()), type, &value, format);
    ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.points(room) -
                         ImGui::CalcTextSize(text.data()).x);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.data());
    ImGui::EndGroup();
    return changed;
}

template <class Number>
bool slider(Ui& ui, const char* id, const char* text, Number& value, Number low, Number high,
            const char* format, const char* help) {
    label(ui, text);
    const bool changed =
        slider_with_number(ui, id, value, low, high, format, 0, measures::number_room);
    tip(ui, help);
    return changed;
}

/// A colour. It has a border, because it may be the colour of the panel.
inline bool swatch(Ui& ui, const char* id, glm::vec3& value, const char* help) {
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
    ImGui::PushStyleColor(ImGuiCol_Border, IM_COL32(190, 188, 182, 255));
    const bool changed =
        ImGui::ColorEdit3((std::string{"##"} + id).c_str(), &value.x, ImGuiColorEditFlags_NoInputs);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    ui.spots.note(id);
    tip(ui, help);
    return changed;
}

inline bool checkbox(Ui& ui, const char* id, const char* text, bool& value) {
    const bool changed = ImGui::Checkbox(text, &value);
    ui.spots.note(id);
    return changed;
}

inline bool button(Ui& ui, const char* id, const char* text, float width = 0) {
    const bool pressed = ImGui::Button((std::string{text} + "##" + id).c_str(), {width, 0});
    ui.spots.note(id);
    return pressed;
}

/// A button that stays pressed while `on`.
inline bool toggle(Ui& ui, const char* id, const char* text, bool on, float width = 0) {
    if (on) {
        ImGui::PushStyleColor(ImGuiCol_Button, theme::colors().accent);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme::colors().accent);
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, theme::colors().accent);
        ImGui::PushStyleColor(ImGuiCol_Text, theme::colors().on_accent);
    }
    const bool pressed = button(ui, id, text, width);
    if (on) ImGui::PopStyleColor(4);
    return pressed;
}

/// Begins a panel that floats over the picture. End it with ImGui::End().
inline void begin_floating(const Ui& ui, const char* name, glm::vec2 low, glm::vec2 size,
                           ImGuiWindowFlags flags = 0) {
    ImGui::SetNextWindowPos({low.x, low.y});
    ImGui::SetNextWindowSize({size.x, size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.points(measures::panel_rounding));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::Begin(name, nullptr,
                 flags | ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar(2);
}

/// Flags of panels with a search_field(), and of lists in them. Arrow keys choose among found rows
/// there.
inline constexpr ImGuiWindowFlags searched_flags = ImGuiWindowFlags_NoNavInputs;

/// A field that keeps the keyboard while its panel is shown. Returns whether Enter was pressed.
inline bool search_field(Ui& ui, SearchState& state, const char* id, const char* hint) {
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
    const std::string before = state.searched;
    const bool entered =
        ImGui::InputTextWithHint((std::string{"##"} + id).c_str(), hint, &state.searched,
                                 ImGuiInputTextFlags_EnterReturnsTrue);
    shown(ui, state.searched); // letters that were pasted
    ui.spots.note(id);
    if (before != state.searched) state.chosen = 0;
    return entered;
}

inline bool key_pressed(ImGuiKey key) {
#if IMGUI_VERSION_NUM >= 18700 // keys have their names
    return ImGui::IsKeyPressed(key);
#else
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
#endif
}

/// Lets arrow keys choose among `count` found rows. Returns whether the choice has changed.
inline bool move_choice(SearchState& state, std::size_t count) {
    const int before = state.chosen, last = std::max(static_cast<int>(count) - 1, 0);
    if (key_pressed(ImGuiKey_DownArrow)) ++state.chosen;
    if (key_pressed(ImGuiKey_UpArrow)) --state.chosen;
    state.chosen = std::clamp(state.chosen, 0, last);
    return state.chosen != before;
}

/// Shows how much is done, 0 to 1. Below 0 the share is not known, and the bar moves.
inline void progress_bar(const Ui& ui, float done) {
    const float width = ui.points(measures::progress.x), height = ui.points(measures::progress.y);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + height}, theme::colors().line, height);
    const auto phase = static_cast<float>(std::fmod(ImGui::GetTime(), 1.6) / 1.6);
    const float from = done < 0 ? std::max(0.0F, 1.3F * phase - 0.3F) : 0;
    const float to = done < 0 ? std::min(1.0F, 1.3F * phase) : std::min(done, 1.0F);
    list.AddRectFilled({low.x + from * width, low.y}, {low.x + to * width, low.y + height},
                       theme::colors().accent, height);
}

inline constexpr ImGuiWindowFlags overlay_flags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
    ImGuiWindowFlags_NoNav;

/// Begins a panel as large as its content. End it with ImGui::End().
inline void begin_overlay(const Ui& ui, const char* name, glm::vec2 at, glm::vec2 pivot,
                          glm::vec2 padding = {14, 12}) {
    ImGui::SetNextWindowPos({at.x, at.y}, ImGuiCond_Always, {pivot.x, pivot.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.points(measures::panel_rounding));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.points(padding.x), ui.points(padding.y)});
    ImGui::Begin(name, nullptr, overlay_flags);
    ImGui::PopStyleVar(3);
}

/// A list for drawing over the picture, clipped at its border. End it with PopClipRect().
inline ImDrawList& list_over(Area canvas) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({canvas.low.x, canvas.low.y},
                      {canvas.low.x + canvas.size.x, canvas.low.y + canvas.size.y});
    return list;
}

/// A text over the picture. It has a ground of its own, because papers may have any colour.
/// `pivot`: the point of the ground that lies at the place, from its upper left corner (0) to the
/// lower right one (1).
inline Area plate(Ui& ui, const std::string& text, glm::vec2 at, glm::vec2 pivot) {
    const ImVec2 letters = ImGui::CalcTextSize(shown(ui, text));
    const glm::vec2 pad{ui.points(8), ui.points(4)};
    const glm::vec2 size = glm::vec2{letters.x, letters.y} + 2.0F * pad;
    const glm::vec2 low = at - pivot * size, high = low + size;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 from{low.x, low.y}, to{high.x, high.y};
    list.AddRectFilled(from, to, theme::colors().panel, ui.points(4));
    list.AddRect(from, to, theme::colors().line, ui.points(4));
    list.AddText({low.x + pad.x, low.y + pad.y}, theme::colors().ink, text.c_str());
    return {low, size};
}

/// The place in the window where a point of the model is seen; nothing if it is not seen.
inline std::optional<ImVec2> place_of(const Session& session, Area canvas, glm::dvec3 point) {
    const auto seen = seen_at(session.navigation.view(), point, session.size());
    if (!seen) return {};
    const glm::vec2 scale = canvas.size / glm::vec2{glm::max(session.size(), 1)};
    const glm::vec2 at = canvas.low + glm::vec2{*seen} * scale;
    return ImVec2{at.x, at.y};
}

/// A list to choose from. `name_of(item)` is the text of an item, `is_chosen(item)` says whether it
/// is the current one, and `choose(item)` is called with a chosen item. Items are noted as
/// "id/name".
template <class Items, class Name, class Chosen, class Choose>
void list_of_choices(Ui& ui, const char* id, const std::string& preview, const Items& items,
                     const Name& name_of_item, const Chosen& is_chosen, const Choose& choose,
                     const char* help, ImGuiComboFlags flags = 0) {
    const bool open = ImGui::BeginCombo((std::string{"##"} + id).c_str(), shown(ui, preview),
                                        flags | ImGuiComboFlags_HeightLargest);
    if (!open) {
        ui.spots.note(id);
        return tip(ui, help);
    }
    for (const auto& item : items) {
        const std::string name = name_of_item(item);
        if (ImGui::Selectable(name.c_str(), is_chosen(item))) choose(item);
        ui.spots.note(std::string{id} + "/" + name);
    }
    ImGui::EndCombo();
}

/// The same as a row with a label.
template <class Items, class Name, class Chosen, class Choose>
void choice(Ui& ui, const char* id, const char* text, const std::string& preview,
            const Items& items, const Name& name_of_item, const Chosen& is_chosen,
            const Choose& choose, const char* help) {
    label(ui, text);
    list_of_choices(ui, id, preview, items, name_of_item, is_chosen, choose, help);
}

} // namespace lineatlas::viewer
