// What an Application does when something happens.

#include <algorithm>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

#include "application.hpp"
#include "lineatlas/style_files.hpp"

namespace lineatlas::viewer {

void Application::on_key(int key, int scancode, int action, int mods) {
    show_soon();
    ImGui_ImplGlfw_KeyCallback(window_.handle(), key, scancode, action, mods);
    shift_ = (mods & GLFW_MOD_SHIFT) != 0;
    if (action == GLFW_RELEASE) {
        mouse_.key(key, false);
        return;
    }
    if (ImGui::GetIO().WantTextInput || action != GLFW_PRESS) return;
    press_key(key, mods);
}

void Application::press_key(int key, int mods) {
    if ((mods & GLFW_MOD_CONTROL) != 0) {
        if (key == GLFW_KEY_S) save_as(ui_, shift_ ? SavedKind::svg : SavedKind::png);
        if (key == GLFW_KEY_Q) window_.close();
        if (key == GLFW_KEY_R) session_.reload();
        if (key == GLFW_KEY_O) show_open_panel(ui_);
        if (key == GLFW_KEY_Y || (key == GLFW_KEY_Z && shift_))
            session_.redo();
        else if (key == GLFW_KEY_Z)
            session_.undo();
        return;
    }
    if ((mods & GLFW_MOD_ALT) != 0) {
        if (key == GLFW_KEY_LEFT) session_.camera_back();
        if (key == GLFW_KEY_RIGHT) session_.camera_forward();
        return;
    }
    if (mouse_.key(key, true)) return;
    Settings& settings = session_.settings;
    switch (key) {
    case GLFW_KEY_F:
        session_.fit();
        break;
    case GLFW_KEY_0:
        session_.glide_to(StandardView::corner);
        break;
    case GLFW_KEY_1:
        session_.glide_to(StandardView::front);
        break;
    case GLFW_KEY_2:
        session_.glide_to(StandardView::right);
        break;
    case GLFW_KEY_3:
        session_.glide_to(StandardView::top);
        break;
    case GLFW_KEY_4:
        session_.glide_to(StandardView::back);
        break;
    case GLFW_KEY_5:
        session_.glide_to(StandardView::left);
        break;
    case GLFW_KEY_6:
        session_.glide_to(StandardView::bottom);
        break;
    case GLFW_KEY_M:
        next_method();
        break;
    case GLFW_KEY_N:
        next_style();
        break;
    case GLFW_KEY_H:
        settings.style.hidden = !settings.style.hidden;
        session_.changed();
        break;
    case GLFW_KEY_X:
        settings.split = !settings.split;
        session_.changed();
        break;
    case GLFW_KEY_DELETE:
        hide_selected();
        break;
    case GLFW_KEY_I:
        isolate_selected();
        break;
    case GLFW_KEY_U:
        session_.hide_parts({});
        break;
    case GLFW_KEY_P:
        session_.toggle_projection();
        break;
    case GLFW_KEY_T:
        ui_.timings = !ui_.timings;
        break;
    case GLFW_KEY_L:
        ui_.theme = ui_.theme == Theme::light ? Theme::dark : Theme::light;
        break;
    case GLFW_KEY_TAB:
        ui_.sidebar = !ui_.sidebar;
        break;
    case GLFW_KEY_F1:
    case GLFW_KEY_SLASH:
        ui_.help = !ui_.help;
        break;
    case GLFW_KEY_ESCAPE:
        press_escape();
        break;
    default:
        break;
    }
}

/// The uppermost thing goes.
void Application::press_escape() {
    if (session_.loader.busy())
        session_.loader.cancel();
    else if (ui_.opening)
        ui_.opening = false;
    else if (ui_.help)
        ui_.help = false;
    else if (!session_.messages.all().empty())
        session_.messages.dismiss(session_.messages.all().size() - 1);
    else
        ui_.timings = false;
}

void Application::hide_selected() {
    if (!session_.selected) return;
    HiddenParts hidden = session_.settings.hidden_parts;
    hidden.insert(*session_.selected);
    session_.hide_parts(std::move(hidden));
}

void Application::isolate_selected() {
    if (session_.selected) session_.hide_parts(session_.model()->parts.all_but(*session_.selected));
}

void Application::next_method() {
    Side& side = session_.settings.sides[0];
    side.method =
        method_labels.at((static_cast<std::size_t>(side.method) + 1) % method_labels.size()).method;
    session_.changed();
}

void Application::next_style() {
    const std::vector<StyleInfo> styles = list_styles();
    const auto now = std::ranges::find(styles, session_.settings.style_name, &StyleInfo::name);
    const auto next = now == styles.end() ? styles.begin() : now + 1;
    session_.use_style(next == styles.end() ? "" : next->name);
}

void Application::on_character(unsigned code) {
    show_soon();
    ImGui_ImplGlfw_CharCallback(window_.handle(), code);
}

void Application::on_mouse_button(int button, int action, int mods) {
    show_soon();
    ImGui_ImplGlfw_MouseButtonCallback(window_.handle(), button, action, mods);
    if (button >= 0 && static_cast<std::size_t>(button) < buttons_.size()) {
        buttons_.at(static_cast<std::size_t>(button)) = action == GLFW_PRESS;
    }
    if (action == GLFW_RELEASE)
        mouse_.release(button, glfwGetTime());
    else if (!ImGui::GetIO().WantCaptureMouse)
        mouse_.press(button, mods, mouse_place_);
}

void Application::on_mouse_move(glm::dvec2 place) {
    show_soon();
    mouse_place_ = place;
    mouse_.move(place);
}

void Application::on_scroll(glm::dvec2 amount) {
    show_soon();
    ImGui_ImplGlfw_ScrollCallback(window_.handle(), amount.x, amount.y);
    if (!ImGui::GetIO().WantCaptureMouse) mouse_.scroll(amount.y, mouse_place_);
}

void Application::on_drop(const std::vector<std::filesystem::path>& files) {
    show_soon();
    for (const std::filesystem::path& file : files) session_.open(file);
}

void Application::on_mouse_leave() {
    show_soon();
    if (!mouse_.dragging()) mouse_place_ = nowhere;
}

void Application::on_focus(bool focused) {
    show_soon();
    ImGui_ImplGlfw_WindowFocusCallback(window_.handle(), focused ? GLFW_TRUE : GLFW_FALSE);
    mouse_.release_keys(); // their release may go to another window
}

void Application::on_refresh() {
    show_soon();
}

} // namespace lineatlas::viewer
