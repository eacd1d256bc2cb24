#include <fmt/format.h>
#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

namespace fs = std::filesystem;

void open(Ui& ui, const fs::path& file) {
    ui.opening = false;
    ui.session.open(file);
}

void recent(Ui& ui) {
    const std::vector<fs::path>& files = ui.session.recent.all();
    if (files.empty()) return;
    ImGui::TextDisabled("Recent");
    // A copy: opening changes the list.
    for (const fs::path& file : std::vector<fs::path>{files}) {
        const std::string name = file.filename().string();
        if (ImGui::Selectable(fmt::format("{}##{}", name, file.string()).c_str())) open(ui, file);
        ui.spots.note("recent:" + name);
        tip(file.c_str());
    }
    ImGui::Separator();
}

void go_to(Ui& ui, const fs::path& folder) {
    ui.open_folder = folder.lexically_normal();
    ui.open_entries = list_folder(ui.open_folder);
}

void folder(Ui& ui) {
    ImGui::TextDisabled("%s", ui.open_folder.c_str());
    ImGui::BeginChild("entries",
                      {0, ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing()});
    if (ui.open_folder.has_relative_path() && ImGui::Selectable("..")) {
        go_to(ui, ui.open_folder.parent_path());
    }
    ui.spots.note("entry:..");
    for (const FileEntry& entry : std::vector<FileEntry>{ui.open_entries}) {
        const std::string name = entry.path.filename().string() + (entry.is_folder ? "/" : "");
        const bool chosen = ImGui::Selectable(name.c_str());
        ui.spots.note("entry:" + name);
        if (chosen && entry.is_folder) go_to(ui, entry.path);
        if (chosen && !entry.is_folder) open(ui, entry.path);
    }
    if (ui.open_entries.empty()) ImGui::TextDisabled("No file that can be opened");
    ImGui::EndChild();
}

} // namespace

void show_open_panel(Ui& ui) {
    ui.opening = true;
    std::error_code failure;
    if (ui.open_folder.empty()) {
        const Model* model = ui.session.model();
        const bool of_model = model != nullptr && !model->source.files.empty();
        ui.open_folder = of_model ? fs::absolute(model->source.files.front(), failure).parent_path()
                                  : fs::current_path(failure);
    }
    go_to(ui, ui.open_folder);
}

void draw_open_panel(Ui& ui, Area canvas) {
    if (!ui.opening) return;
    const glm::vec2 size =
        glm::min(canvas.size - ui.points(40), ui.points(1) * glm::vec2{520, 560});
    const glm::vec2 low = canvas.low + 0.5F * (canvas.size - size);
    begin_floating(ui, "open", low, size);
    heading(ui, "Open");
    recent(ui);
    folder(ui);
    if (button(ui, "open.close", "Close")) ui.opening = false;
    ImGui::End();
}

} // namespace lineatlas::viewer
