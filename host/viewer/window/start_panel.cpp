// The text of an empty window: which files it opens, and what the mouse does.
#include <algorithm>
#include <array>
#include <utility>

#include "io/model_types.hpp"
#include "viewer/examples.hpp"
#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

namespace fs = std::filesystem;

void recent_files(Ui& ui) {
    constexpr std::size_t most = 5;
    // This is a copy, because opening a file changes the list.
    std::vector<fs::path> files = ui.session.recent.all();
    if (files.empty()) return;
    if (files.size() > most) files.resize(most);
    heading(ui, "Recent");
    for (const fs::path& file : files) {
        const std::string name = file.filename().string();
        const std::string id = name + "##start" + file.string();
        if (ImGui::Selectable(shown(ui, id))) ui.session.open(file);
        ui.spots.note("start.recent:" + name);
        tip(ui, file.c_str());
        ImGui::SameLine();
        ImGui::TextDisabled("%s", shown(ui, file.parent_path().string()));
    }
}

void examples(Ui& ui) {
    heading(ui, "Examples");
    for (const Example& example : all_examples()) {
        if (example.scene != all_examples().front().scene) ImGui::SameLine();
        const std::string scene{example.scene};
        if (button(ui, ("example." + scene).c_str(), example.label)) ui.session.open_scene(scene);
        tip(ui, example.what);
    }
}

void gestures(Ui& ui) {
    heading(ui, "With a model");
    constexpr std::array rows{std::pair{"Left drag", "turns it about the point under the mouse"},
                              std::pair{"Middle drag", "moves it"},
                              std::pair{"Wheel", "goes nearer, and away"}};
    for (const auto& [gesture, what] : rows) {
        ImGui::TextUnformatted(gesture);
        column(ui, 110);
        ImGui::TextDisabled("%s", what);
    }
}

} // namespace

void draw_start_panel(Ui& ui, Area canvas) {
    ImGui::SetNextWindowSize({std::min(ui.points(500), canvas.size.x - ui.points(40)), 0});
    begin_overlay(ui, "start", canvas.low + 0.5F * canvas.size, {0.5F, 0.5F}, {24, 18});
    heading(ui, "Line drawings of 3D models");
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("Drop a file here, or open one: %s, or a session.",
                        model_type_names(", ").c_str());
    ImGui::PopTextWrapPos();
    if (toggle(ui, "start.open", "Open ...", true)) switch_panel(ui, Panel::open);
    tip(ui, "Files of a folder, found by typing (Ctrl + O)");
    recent_files(ui);
    examples(ui);
    gestures(ui);
    ImGui::End();
}

} // namespace lineatlas::viewer
