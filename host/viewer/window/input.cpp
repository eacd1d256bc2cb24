// How an Application responds to events.

#include <algorithm>
#include <array>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

#include "application.hpp"
#include "commands.hpp"

namespace lineatlas::viewer {
namespace {

/// Whether a key keeps its meaning while text is typed.
bool is_for_all(int key, int mods) {
    constexpr std::array of_text{GLFW_KEY_A, GLFW_KEY_C, GLFW_KEY_V,    GLFW_KEY_X,
                                 GLFW_KEY_Y, GLFW_KEY_Z, GLFW_KEY_LEFT, GLFW_KEY_RIGHT};
    return (mods & GLFW_MOD_CONTROL) != 0 && std::ranges::find(of_text, key) == of_text.end();
}

} // namespace

void Application::on_key(int key, int scancode, int action, int mods) {
    show_soon();
    ImGui_ImplGlfw_KeyCallback(window_.handle(), key, scancode, action, mods);
    shift_ = (mods & GLFW_MOD_SHIFT) != 0;
    if (action == GLFW_RELEASE) {
        mouse_.key(key, false);
        return;
    }
    const bool of_panel = key == GLFW_KEY_ESCAPE && ui_.panel != Panel::none && !menu_is_open();
    if (of_panel) return press_escape();
    if (action != GLFW_PRESS || (letters_are_text() && !is_for_all(key, mods))) return;
    press_key(key, mods);
}

void Application::press_key(int key, int mods) {
    if (key == GLFW_KEY_ESCAPE) return press_escape();
    const Command* command = command_of(key, mods);
    if (command != nullptr) return command->run(ui_);
    if ((mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT)) == 0) mouse_.key(key, true);
}

/// Closes the uppermost thing.
void Application::press_escape() {
    const Waiting now = waiting(ui_);
    if (ui_.panel != Panel::none)
        ui_.panel = Panel::none;
    else if (now == Waiting::recording)
        session_.cancel_recording();
    else if (now == Waiting::work && session_.can_cancel_work())
        session_.cancel_work();
    else if (session_.loader.busy())
        session_.cancel_loading();
    else if (session_.measuring())
        session_.toggle_measuring();
    else if (!session_.messages.all().empty())
        session_.messages.dismiss(session_.messages.all().size() - 1);
    else
        ui_.timings = false;
}

void Application::on_character(unsigned code) {
    show_soon();
    if (code > last_usual_letter) ui_.letters.insert(code);
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
    session_.open(files);
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
