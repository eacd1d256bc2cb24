// The panel of files, which one searches by typing.
#include <algorithm>

#include "widgets.hpp"

namespace lineatlas::viewer {
namespace {

namespace fs = std::filesystem;

struct Row {
    enum class Kind { recent, folder, file };
    Kind kind;
    fs::path path;
    std::string name; ///< as it is read
};

/// A typed text: the folder in it, as far as that exists, and the beginning of a name.
struct Typed {
    fs::path folder;
    std::string name;
};

Typed typed_in(const OpenState& state) {
    const std::string& text = state.search.searched;
    const std::size_t slash = text.rfind('/');
    if (slash == std::string::npos) return {state.folder, text};
    return {(state.folder / text.substr(0, slash + 1)).lexically_normal(), text.substr(slash + 1)};
}

void list(OpenState& state, const fs::path& folder) {
    if (state.listed == folder) return;
    state.listed = folder;
    state.entries = list_folder(folder);
}

/// Recent files, unless another folder is typed, then the entries of the folder.
std::vector<Row> rows_of(const Ui& ui, const Typed& typed) {
    std::vector<Row> rows;
    if (typed.folder == ui.open.folder)
        for (const fs::path& file : ui.session.recent.all())
            if (contains(file.string(), typed.name))
                rows.push_back({Row::Kind::recent, file, file.filename().string()});
    if (typed.name.empty() && typed.folder.has_relative_path())
        rows.push_back({Row::Kind::folder, (typed.folder / "..").lexically_normal(), "../"});
    for (const FileEntry& entry : ui.open.entries) {
        const std::string name = entry.path.filename().string();
        if (!contains(name, typed.name)) continue;
        rows.push_back(entry.is_folder ? Row{Row::Kind::folder, entry.path, name + "/"}
                                       : Row{Row::Kind::file, entry.path, name});
    }
    return rows;
}

void enter(OpenState& state, const fs::path& folder) {
    state.folder = folder;
    state.search = {};
    list(state, folder);
}

void take(Ui& ui, const fs::path& path) {
    std::error_code failure;
    if (fs::is_directory(path, failure)) return enter(ui.open, path);
    ui.panel = Panel::none;
    ui.session.open(path);
}

/// Draws a row. Returns whether it was clicked.
bool draw_row(Ui& ui, const Row& row, bool chosen, bool scrolls_here) {
    const bool recent = row.kind == Row::Kind::recent;
    const std::string id = row.name + "##" + (recent ? "recent" : "") + row.path.string();
    const bool clicked = ImGui::Selectable(shown(ui, id), chosen);
    ui.spots.note((recent ? "recent:" : "entry:") + row.name);
    if (chosen && scrolls_here) ImGui::SetScrollHereY();
    if (!recent) return clicked;
    ImGui::SameLine();
    ImGui::TextDisabled("%s", shown(ui, row.path.parent_path().string()));
    return clicked;
}

/// Draws recent files, then those of the listed folder, each list with a heading.
std::optional<fs::path> draw_rows(Ui& ui, const std::vector<Row>& rows, bool scrolls_here) {
    std::optional<fs::path> clicked;
    const auto is_recent = [&](std::size_t i) { return rows[i].kind == Row::Kind::recent; };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool first = i == 0 || is_recent(i) != is_recent(i - 1);
        if (first && i > 0) ImGui::Separator();
        if (first)
            ImGui::TextDisabled("%s", is_recent(i) ? "Recent" : shown(ui, ui.open.listed.string()));
        const bool chosen = static_cast<int>(i) == ui.open.search.chosen;
        if (draw_row(ui, rows[i], chosen, scrolls_here)) clicked = rows[i].path;
    }
    if (rows.empty()) ImGui::TextDisabled("No file of that name can be opened");
    return clicked;
}

/// The path that Enter opens: the typed path if it exists, else the chosen row. A path that leads
/// nowhere is opened too, which reports the error.
std::optional<fs::path> entered(const OpenState& state, const std::vector<Row>& rows) {
    std::error_code failure;
    const std::string& text = state.search.searched;
    const fs::path path = (state.folder / text).lexically_normal();
    if (!text.empty() && (rows.empty() || fs::exists(path, failure))) return path;
    if (rows.empty()) return {};
    return rows[static_cast<std::size_t>(state.search.chosen)].path;
}

fs::path first_folder(const Session& session) {
    std::error_code failure;
    const Model* model = session.model();
    const bool of_model = model != nullptr && !model->source.files.empty();
    return of_model ? fs::absolute(model->source.files.front(), failure).parent_path()
                    : fs::current_path(failure);
}

} // namespace

void switch_panel(Ui& ui, Panel panel) {
    ui.panel = ui.panel == panel ? Panel::none : panel;
    ui.palette = {};
    if (panel == Panel::exporting) begin_export(ui);
    if (panel != Panel::open) return;
    ui.session.recent.forget_lost();
    const fs::path folder = ui.open.folder.empty() ? first_folder(ui.session) : ui.open.folder;
    ui.open = {};
    enter(ui.open, folder);
}

void draw_open_panel(Ui& ui, Area canvas) {
    if (ui.panel != Panel::open) return;
    const glm::vec2 size =
        glm::min(canvas.size - ui.points(40), ui.points(1) * glm::vec2{520, 560});
    begin_floating(ui, "open", canvas.low + 0.5F * (canvas.size - size), size, searched_flags);
    heading(ui, "Open");
    const bool enter_pressed =
        search_field(ui, ui.open.search, "open.search", "Type a name or a path");
    const Typed typed = typed_in(ui.open);
    list(ui.open, typed.folder);
    const std::vector<Row> rows = rows_of(ui, typed);
    const bool moved = move_choice(ui.open.search, rows.size());
    ImGui::BeginChild("entries",
                      {0, ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing()},
                      false, searched_flags);
    std::optional<fs::path> taken = draw_rows(ui, rows, moved);
    ImGui::EndChild();
    if (enter_pressed) taken = entered(ui.open, rows);
    if (button(ui, "open.close", "Close")) ui.panel = Panel::none;
    tip(ui, "Esc");
    ImGui::End();
    if (taken) take(ui, *taken);
}

} // namespace lineatlas::viewer
