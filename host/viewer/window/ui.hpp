#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <imgui.h>

#include "theme.hpp"
#include "viewer/session.hpp"

namespace lineatlas::viewer {

/// Part of the window in points.
struct Area {
    glm::vec2 low{0}, size{0};

    bool holds(glm::dvec2 p) const {
        return p.x >= low.x && p.y >= low.y && p.x < low.x + size.x && p.y < low.y + size.y;
    }
};

/// The places of the last frame's items, by name, for tests that press them.
class Spots {
  public:
    void begin_frame() {
        areas_.clear();
        with_tips_.clear();
    }
    void note(const std::string& name, Area area) { areas_[name] = area; }
    /// Notes the item that was made last.
    void note(const std::string& name) {
        const ImVec2 low = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
        areas_[name] = {{low.x, low.y}, {size.x, size.y}};
        last_ = name;
    }
    /// Notes that the last item has a tip.
    void note_tip() { with_tips_.insert(last_); }
    bool has_tip(const std::string& name) const { return with_tips_.contains(name); }
    const std::map<std::string, Area>& all() const { return areas_; }
    std::optional<Area> find(const std::string& name) const {
        const auto found = areas_.find(name);
        if (found == areas_.end()) return {};
        return found->second;
    }

  private:
    std::map<std::string, Area> areas_;
    std::set<std::string> with_tips_;
    std::string last_;
};

/// A device that one can choose.
struct DeviceChoice {
    std::string label;
    DeviceOptions options;
};

/// The panels that float over the picture, one at a time.
enum class Panel { none, open, exporting, palette, keys };

/// The state of a list that one searches by typing.
struct SearchState {
    std::string searched{};
    int chosen = 0; ///< row among those that are found
};

/// The state of the panel of files.
struct OpenState {
    SearchState search{};
    std::filesystem::path folder{}; ///< where a typed path begins
    std::filesystem::path listed{}; ///< the folder that `entries` are of
    std::vector<FileEntry> entries{};
};

/// The state of the panel of exports. It is kept when the panel closes.
struct ExportState {
    ExportOptions options{};
    std::string scale{}; ///< as it is typed
    std::string name{};  ///< of the file
};

/// What the panels need besides the session.
struct Ui {
    Session& session;
    Spots spots{};
    Letters letters{}; ///< letters of texts beyond the usual ones
    ImFont* bold = nullptr;
    float scale = 1; ///< of letters and spacing
    Theme theme = Theme::light;
    std::set<std::string> folded{"advanced"}; ///< sections of the sidebar
    float parts_height = 0; ///< of the list of parts, points; 0: that of its rows, up to a limit
    bool sidebar = true, timings = false;
    std::vector<DeviceChoice> devices{};
    Panel panel = Panel::none;
    SearchState palette{};
    OpenState open{};
    ExportState exporting{};
    bool quit = false;                ///< the window is to be closed
    bool keyboard_to_sidebar = false; ///< arrows and Enter are for its items from now on
    /// The panel of timings shows kernels in place of stages.
    bool kernels = false;
    std::string part_search{};               ///< the typed search for parts
    std::set<std::uint32_t> folded_parts{};  ///< the parts in them are not listed
    std::uint32_t part_anchor = Parts::none; ///< where a row of selected parts begins
    bool opens_menu = false;                 ///< opens the menu of parts where the mouse is
    int record_frames = 120;                 ///< of a recording
    std::string folder = ".";                ///< where files are saved
    /// Work during which the window cannot respond. It is done after a frame that says so.
    std::optional<std::pair<std::string, std::function<void()>>> later{};

    void do_later(const std::string& what, std::function<void()> work) {
        later = std::pair{what, std::move(work)};
    }
    float points(float usual) const { return usual * scale; }
};

/// What is shown of all that a person waits for, and what Esc cancels first.
enum class Waiting { nothing, recording, loading, work };
Waiting waiting(const Ui& ui);

/// Saves a file under a free name made of the model's name; a session under its old name.
enum class SavedKind { session, png, svg, style, camera, trace };
void save_as(Ui& ui, SavedKind kind);

float sidebar_width(const Ui& ui);
/// The place of the picture, which neither the tool bar nor the sidebar covers.
Area canvas_area(const Ui& ui, glm::vec2 window);

// Parts of the window; each is a file.
void draw_sidebar(Ui& ui, Area area);
void draw_parts_section(Ui& ui);
/// Draws the menu of the selected parts.
void draw_parts_menu(Ui& ui);
void draw_sections_section(Ui& ui);
void draw_style_section(Ui& ui);
void draw_lines_section(Ui& ui);
void draw_views_section(Ui& ui);
void draw_advanced_section(Ui& ui);
void draw_device_rows(Ui& ui); ///< of that
/// Draws the planes of cuts, with handles to drag.
void draw_cuts(Ui& ui, Area canvas);
void draw_distances(Ui& ui, Area canvas);
void draw_canvas_overlays(Ui& ui, Area canvas);
void draw_start_panel(Ui& ui, Area canvas);
void draw_gizmo(Ui& ui, Area canvas);
void draw_timings(Ui& ui, Area canvas);
void draw_messages(Ui& ui, Area canvas);
void draw_help(Ui& ui);
void draw_palette(Ui& ui, Area canvas);
void draw_open_panel(Ui& ui, Area canvas);
void draw_export_panel(Ui& ui);
/// Opens the panel of exports with a name for the file.
void begin_export(Ui& ui);
/// Shows a panel in place of the current one, or closes it if it is that. The panel of files lists
/// the folder of the model, or the folder that was listed last.
void switch_panel(Ui& ui, Panel panel);
/// Whether letters are no shortcuts while a panel is shown.
inline bool takes_letters(Panel panel) {
    return panel != Panel::none && panel != Panel::keys;
}
/// Whether a panel has a field that keeps the keyboard.
inline bool has_search(Panel panel) {
    return panel == Panel::open || panel == Panel::palette;
}

} // namespace lineatlas::viewer
