#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/drawing_thread.hpp"

struct GLFWwindow;

namespace lineatlas::viewer {

/// The receiver of the user's events. Places are in points of the window, from its upper left
/// corner.
class InputListener {
  public:
    virtual ~InputListener() = default;
    virtual void on_key(int key, int scancode, int action, int mods) = 0;
    virtual void on_character(unsigned code) = 0;
    virtual void on_mouse_button(int button, int action, int mods) = 0;
    virtual void on_mouse_move(glm::dvec2 place) = 0;
    virtual void on_scroll(glm::dvec2 amount) = 0;
    virtual void on_drop(const std::vector<std::filesystem::path>& files) = 0;
    virtual void on_mouse_leave() = 0;
    virtual void on_focus(bool focused) = 0;
    virtual void on_refresh() = 0; ///< the window's size has changed, or it must be shown again
};

/// Keeps events in their order, however many come during one frame. ImGui knows only the state of
/// keys and buttons, so it is shown one event after the other.
class InputQueue final : public InputListener {
  public:
    void on_key(int key, int scancode, int action, int mods) override;
    void on_character(unsigned code) override;
    void on_mouse_button(int button, int action, int mods) override;
    void on_mouse_move(glm::dvec2 place) override;
    void on_scroll(glm::dvec2 amount) override;
    void on_drop(const std::vector<std::filesystem::path>& files) override;
    void on_mouse_leave() override;
    void on_focus(bool focused) override;
    void on_refresh() override;

    bool empty() const { return events_.empty(); }
    /// Passes on the first event. Moves of the mouse in a row are passed on together, and so are
    /// turns of the wheel, because nothing happens between them.
    void pass_next_to(InputListener& listener);

  private:
    enum class Kind { alone, move, scroll };
    struct Event {
        Kind kind;
        std::function<void(InputListener&)> tell;
    };
    std::deque<Event> events_;
};

/// A window with a GL 4.5 core context, current on the thread that made it.
class Window {
  public:
    /// Throws DeviceError that says what to do.
    Window(glm::ivec2 size, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void listen(InputListener* listener) { listener_ = listener; }
    GLFWwindow* handle() const { return window_; }
    InputListener* listener() const { return listener_; }

    glm::ivec2 points() const;
    glm::ivec2 pixels() const;
    /// Pixels per point; not 1 if the system scales windows itself.
    float pixels_per_point() const;
    /// How large the system wants letters to be, in points: 1 is usual.
    float content_scale() const;
    void set_title(const std::string& title);
    bool should_close() const;
    void close();
    void show_frame(); ///< swaps buffers
    /// Waits for an event, at most `seconds`; below 0: without end.
    static void wait(double seconds);
    static void wake(); ///< ends wait(), from any thread
    /// A context that shares with the window's, for another thread.
    SharedContext& context() { return context_; }

  private:
    /// A window that nobody sees has it.
    class OtherContext final : public SharedContext {
      public:
        void open(GLFWwindow* beside);
        void close();
        void make_current() override;
        void release() override;

      private:
        GLFWwindow* window_ = nullptr;
    };

    OtherContext context_;
    GLFWwindow* window_ = nullptr;
    InputListener* listener_ = nullptr;
};

} // namespace lineatlas::viewer
