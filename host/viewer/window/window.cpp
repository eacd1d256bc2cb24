#include "window.hpp"

#include <cstdlib>
#include <filesystem>

#include <GLFW/glfw3.h>

#include "lineatlas/error.hpp"

namespace lineatlas::viewer {
namespace {

std::string last_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text == nullptr ? "" : std::string{": "} + text;
}

/// An environment variable; empty if it is not set.
std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

bool has_x11() {
    return !variable("DISPLAY").empty();
}

/// Whether there is a Wayland display, looked for as Wayland's own library does.
bool has_wayland() {
    if (!variable("WAYLAND_SOCKET").empty()) return true;
    const std::string display = variable("WAYLAND_DISPLAY");
    const std::filesystem::path name = display.empty() ? "wayland-0" : display;
    const std::string folder = variable("XDG_RUNTIME_DIR");
    std::error_code error;
    return (name.is_absolute() || !folder.empty()) &&
           std::filesystem::exists(std::filesystem::path(folder) / name, error);
}

DeviceError no_window(const std::string& cause) {
    return DeviceError("the viewer cannot open a window" + cause +
                       "; it needs X11 or Wayland, `lineatlas draw` does not");
}

/// Starts GLFW. Does not ask for a display that is missing, because libraries would print messages
/// of their own.
void start_glfw() {
    if (!has_x11() && !has_wayland())
        throw no_window(": neither DISPLAY nor WAYLAND_DISPLAY names a display");
#ifdef GLFW_PLATFORM // since 3.4, which asks Wayland first
    if (!has_wayland()) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (glfwInit() != GLFW_TRUE) throw no_window(last_error());
}

InputListener* listener_of(GLFWwindow* window) {
    return static_cast<Window*>(glfwGetWindowUserPointer(window))->listener();
}

void refresh(GLFWwindow* window) {
    if (InputListener* listener = listener_of(window)) listener->on_refresh();
}

void set_callbacks(GLFWwindow* window) {
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        if (InputListener* l = listener_of(w)) l->on_key(key, scancode, action, mods);
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code) {
        if (InputListener* l = listener_of(w)) l->on_character(code);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
        if (InputListener* l = listener_of(w)) l->on_mouse_button(button, action, mods);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        if (InputListener* l = listener_of(w)) l->on_mouse_move({x, y});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        if (InputListener* l = listener_of(w)) l->on_scroll({x, y});
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        if (InputListener* l = listener_of(w)) l->on_drop({paths, paths + count});
    });
    glfwSetWindowRefreshCallback(window, refresh);
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { refresh(w); });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        InputListener* l = listener_of(w);
        if (l != nullptr && entered == GLFW_FALSE) l->on_mouse_leave();
    });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
        if (InputListener* l = listener_of(w)) l->on_focus(focused != GLFW_FALSE);
    });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { refresh(w); });
}

} // namespace

Window::Window(glm::ivec2 size, const std::string& title) {
    start_glfw();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0); // pictures are drawn off screen
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
        const std::string cause = last_error();
        glfwTerminate();
        throw DeviceError("the viewer needs OpenGL 4.5" + cause);
    }
    glfwSetWindowUserPointer(window_, this);
    glfwSetWindowSizeLimits(window_, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
    context_.open(window_);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    set_callbacks(window_);
}

void Window::OtherContext::open(GLFWwindow* beside) {
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    window_ = glfwCreateWindow(1, 1, "", nullptr, beside);
    glfwWindowHint(GLFW_VISIBLE, GLFW_TRUE);
    if (window_ != nullptr) return;
    const std::string cause = last_error();
    glfwTerminate();
    throw DeviceError("the viewer needs two OpenGL contexts that share" + cause);
}

void Window::OtherContext::close() {
    glfwDestroyWindow(window_);
}

void Window::OtherContext::make_current() {
    glfwMakeContextCurrent(window_);
}

void Window::OtherContext::release() {
    glfwMakeContextCurrent(nullptr);
}

Window::~Window() {
    context_.close();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

glm::ivec2 Window::points() const {
    glm::ivec2 size{0};
    glfwGetWindowSize(window_, &size.x, &size.y);
    return size;
}

glm::ivec2 Window::pixels() const {
    glm::ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

float Window::pixels_per_point() const {
    const glm::ivec2 all_points = points();
    return all_points.x > 0 ? static_cast<float>(pixels().x) / static_cast<float>(all_points.x) : 1;
}

float Window::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return x > 0 ? x / pixels_per_point() : 1;
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

bool Window::should_close() const {
    return glfwWindowShouldClose(window_) != GLFW_FALSE;
}

void Window::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::show_frame() {
    glfwSwapBuffers(window_);
}

void Window::wait(double seconds) {
    if (seconds == 0)
        glfwPollEvents();
    else if (seconds < 0)
        glfwWaitEvents();
    else
        glfwWaitEventsTimeout(seconds);
}

void Window::wake() {
    glfwPostEmptyEvent();
}

} // namespace lineatlas::viewer
