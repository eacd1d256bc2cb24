#include "commands.hpp"

#include <algorithm>
#include <array>

#include <GLFW/glfw3.h>

#include "lineatlas/style_files.hpp"

namespace lineatlas::viewer {
namespace {

constexpr int ctrl = GLFW_MOD_CONTROL, shift = GLFW_MOD_SHIFT, alt = GLFW_MOD_ALT;

template <StandardView view>
void look_from(Ui& ui) {
    ui.session.glide_to(view);
}

template <SavedKind kind>
void save(Ui& ui) {
    save_as(ui, kind);
}

template <Panel panel>
void show(Ui& ui) {
    switch_panel(ui, panel);
}

template <Session::Move move>
void record(Ui& ui) {
    ui.session.start_recording(move, ui.folder, ui.record_frames);
}

void next_method(Ui& ui) {
    Side& side = ui.session.settings.sides[0];
    side.method =
        method_labels.at((static_cast<std::size_t>(side.method) + 1) % method_labels.size()).method;
    ui.session.changed();
}

void next_style(Ui& ui) {
    const std::vector<StyleInfo> styles = list_styles();
    const auto now = std::ranges::find(styles, ui.session.settings.style_name, &StyleInfo::name);
    const auto next = now == styles.end() ? styles.begin() : now + 1;
    ui.session.use_style(next == styles.end() ? "" : next->name);
}

void toggle_hidden_lines(Ui& ui) {
    ui.session.settings.style.hidden = !ui.session.settings.style.hidden;
    ui.session.changed();
}

void toggle_split(Ui& ui) {
    ui.session.settings.split = !ui.session.settings.split;
    ui.session.changed();
}

/// Moves the last cut by a share of the model.
void move_cut(Ui& ui, double share) {
    std::vector<Cut> cuts = ui.session.settings.shown.cuts;
    if (cuts.empty()) return;
    Cut& cut = cuts.back();
    const Reach reach = reach_along(cut.normal, ui.session.whole_bounds(), ui.session.origin());
    cut.at = std::clamp(cut.at + share * (reach.high - reach.low), reach.low, reach.high);
    ui.session.set_cuts(std::move(cuts));
}

void flip_cut(Ui& ui) {
    std::vector<Cut> cuts = ui.session.settings.shown.cuts;
    if (cuts.empty()) return;
    cuts.back() = flipped(cuts.back());
    ui.session.set_cuts(std::move(cuts));
}

void remove_distances(Ui& ui) {
    ui.session.settings.distances.clear();
    ui.session.changed();
}

void keyboard_to_sidebar(Ui& ui) {
    ui.sidebar = ui.keyboard_to_sidebar = true;
}

void switch_theme(Ui& ui) {
    ui.theme = ui.theme == Theme::light ? Theme::dark : Theme::light;
}

constexpr std::array all{
    Command{"Fit the model", GLFW_KEY_F, 0, [](Ui& ui) { ui.session.fit(); }},
    Command{"Look from the front", GLFW_KEY_1, 0, look_from<StandardView::front>},
    Command{"Look from the right", GLFW_KEY_2, 0, look_from<StandardView::right>},
    Command{"Look from the top", GLFW_KEY_3, 0, look_from<StandardView::top>},
    Command{"Look from the back", GLFW_KEY_4, 0, look_from<StandardView::back>},
    Command{"Look from the left", GLFW_KEY_5, 0, look_from<StandardView::left>},
    Command{"Look from the bottom", GLFW_KEY_6, 0, look_from<StandardView::bottom>},
    Command{"Look from a corner", GLFW_KEY_0, 0, look_from<StandardView::corner>},
    Command{"Parallel lines of sight", GLFW_KEY_P, 0,
            [](Ui& ui) { ui.session.toggle_projection(); }},
    Command{"Keep this view", GLFW_KEY_B, 0, [](Ui& ui) { ui.session.add_bookmark(); }},
    Command{"The camera before", GLFW_KEY_LEFT, alt, [](Ui& ui) { ui.session.camera_back(); }},
    Command{"The camera after", GLFW_KEY_RIGHT, alt, [](Ui& ui) { ui.session.camera_forward(); }},

    Command{"Hide what is selected", GLFW_KEY_DELETE, 0,
            [](Ui& ui) { ui.session.hide_selected(); }},
    Command{"Show what is selected alone", GLFW_KEY_I, 0,
            [](Ui& ui) { ui.session.isolate_selected(); }},
    Command{"Frame what is selected", GLFW_KEY_F, shift,
            [](Ui& ui) { ui.session.frame_selected(); }},
    Command{"Show all parts", GLFW_KEY_U, 0, [](Ui& ui) { ui.session.show_parts({}); }},
    Command{"Add a section", GLFW_KEY_C, 0, [](Ui& ui) { ui.session.add_cut(); }},
    Command{"Move the last section ahead", GLFW_KEY_RIGHT_BRACKET, 0,
            [](Ui& ui) { move_cut(ui, 0.01); }},
    Command{"Move the last section back", GLFW_KEY_LEFT_BRACKET, 0,
            [](Ui& ui) { move_cut(ui, -0.01); }},
    Command{"Flip the last section", GLFW_KEY_C, shift, flip_cut},
    Command{"Remove all sections", 0, 0, [](Ui& ui) { ui.session.set_cuts({}); }},

    Command{"Measure a distance", GLFW_KEY_R, 0, [](Ui& ui) { ui.session.toggle_measuring(); }},
    Command{"Remove all distances", 0, 0, remove_distances},

    Command{"Next method", GLFW_KEY_M, 0, next_method},
    Command{"Next style", GLFW_KEY_N, 0, next_style},
    Command{"Hidden lines", GLFW_KEY_H, 0, toggle_hidden_lines},
    Command{"Split screen", GLFW_KEY_X, 0, toggle_split},
    Command{"Undo", GLFW_KEY_Z, ctrl, [](Ui& ui) { ui.session.undo(); }},
    Command{"Redo", GLFW_KEY_Y, ctrl, [](Ui& ui) { ui.session.redo(); }},

    Command{"Open a file", GLFW_KEY_O, ctrl, show<Panel::open>},
    Command{"Read the file again", GLFW_KEY_R, ctrl, [](Ui& ui) { ui.session.reload(); }},
    Command{"Save the session", GLFW_KEY_S, ctrl, save<SavedKind::session>},
    Command{"Export a drawing", GLFW_KEY_E, ctrl, show<Panel::exporting>},
    Command{"Save the picture as PNG", GLFW_KEY_E, ctrl | shift, save<SavedKind::png>},
    Command{"Save the paths as SVG", 0, 0, save<SavedKind::svg>},
    Command{"Record a turntable", 0, 0, record<Session::Move::turntable>},
    Command{"Record the way through the kept views", 0, 0, record<Session::Move::kept_views>},
    Command{"Save the style", 0, 0, save<SavedKind::style>},
    Command{"Save the camera", 0, 0, save<SavedKind::camera>},

    Command{"Find a command", GLFW_KEY_P, ctrl, show<Panel::palette>},
    Command{"Sidebar", GLFW_KEY_TAB, 0, [](Ui& ui) { ui.sidebar = !ui.sidebar; }},
    Command{"Keyboard into the sidebar", GLFW_KEY_F6, 0, keyboard_to_sidebar},
    Command{"Timings", GLFW_KEY_T, 0, [](Ui& ui) { ui.timings = !ui.timings; }},
    Command{"Save the timings as a trace", 0, 0, save<SavedKind::trace>},
    Command{"Light or dark panels", GLFW_KEY_L, 0, switch_theme},
    Command{"Keys", GLFW_KEY_F1, 0, show<Panel::keys>},
    Command{"Quit", GLFW_KEY_Q, ctrl, [](Ui& ui) { ui.quit = true; }},
};

/// Further keys that people know from other programs.
constexpr std::array others{
    Command{"", GLFW_KEY_Z, ctrl | shift, [](Ui& ui) { ui.session.redo(); }},
    Command{"", GLFW_KEY_SLASH, 0, show<Panel::keys>},
};

std::string name_of_key(int key) {
    if (key > GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT) return {static_cast<char>(key)};
    switch (key) {
    case GLFW_KEY_LEFT:
        return "left";
    case GLFW_KEY_RIGHT:
        return "right";
    case GLFW_KEY_DELETE:
        return "Delete";
    case GLFW_KEY_TAB:
        return "Tab";
    case GLFW_KEY_F1:
        return "F1";
    case GLFW_KEY_F6:
        return "F6";
    default:
        return "?";
    }
}

} // namespace

std::span<const Command> commands() {
    return all;
}

std::string key_text(const Command& command) {
    if (command.key == 0) return {};
    std::string text;
    if ((command.mods & ctrl) != 0) text += "Ctrl + ";
    if ((command.mods & alt) != 0) text += "Alt + ";
    if ((command.mods & shift) != 0) text += "Shift + ";
    return text + name_of_key(command.key);
}

const Command* command_of(int key, int mods) {
    const auto is_it = [&](const Command& command) {
        return command.key != 0 && command.key == key &&
               command.mods == (mods & (ctrl | shift | alt));
    };
    for (const std::span<const Command> table : {std::span<const Command>{all}, {others}}) {
        const auto found = std::ranges::find_if(table, is_it);
        if (found != table.end()) return &*found;
    }
    return nullptr;
}

} // namespace lineatlas::viewer
