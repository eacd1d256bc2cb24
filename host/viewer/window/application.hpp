#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "canvas_mouse.hpp"
#include "glpasses/objects.hpp"
#include "theme.hpp"
#include "ui.hpp"
#include "window.hpp"

namespace lineatlas::viewer {

struct ApplicationOptions {
    glm::ivec2 size{1280, 800}; ///< of the window, in points
    DeviceOptions device{};
    float scale = 0;              ///< of letters; 0: as the system wants
    std::optional<Theme> theme{}; ///< none: as the desktop wants
    bool scripted =
        false; ///< pictures become exact at once and do not wait for a hand to rest; for tests
    double seconds_a_step = 0; ///< by which glides and notices go on; 0: as time goes; for tests
};

/// The viewer: a session in a window.
class Application final : private InputListener {
  public:
    Application(const ApplicationOptions& options, ImageWriter& writer);
    ~Application() override;

    Session& session() { return session_; }
    Ui& ui() { return ui_; }
    Window& window() { return window_; }
    /// The receiver of the window's events. step() takes them from there.
    InputListener& input() { return queue_; }

    /// Runs until the window is closed.
    void run();
    /// Waits for an event, at most `longest_wait` seconds (below 0: without end), and shows its
    /// effect.
    void step(double longest_wait);
    /// Frames of the window that were shown.
    std::uint64_t frames_shown() const { return frames_shown_; }
    /// The pixels that the window shows.
    Image screenshot() const;

  private:
    void on_key(int key, int scancode, int action, int mods) override;
    void on_character(unsigned code) override;
    void on_mouse_button(int button, int action, int mods) override;
    void on_mouse_move(glm::dvec2 place) override;
    void on_scroll(glm::dvec2 amount) override;
    void on_drop(const std::vector<std::filesystem::path>& files) override;
    void on_mouse_leave() override;
    void on_focus(bool focused) override;
    void on_refresh() override;

    /// ImGui with its connections to GLFW and GL.
    class Gui {
      public:
        explicit Gui(GLFWwindow* window);
        ~Gui();
        Gui(const Gui&) = delete;
        Gui& operator=(const Gui&) = delete;
    };

    double seconds_to_wait() const;
    bool shows_preview() const;
    std::optional<double> seconds_to_refine() const;
    void advance();
    void fit_scale();
    Area canvas_area() const;
    void make_frame();
    void show_frame();
    void note_picture();
    void paint() const;
    void blit_pictures() const;
    void take_input();
    void give_keyboard();
    static bool field_has_keyboard();
    static bool menu_is_open();
    bool letters_are_text() const;
    void press_key(int key, int mods);
    void press_escape();
    void show_soon();
    bool shows_moved_picture() const;

    ApplicationOptions options_;
    InputQueue queue_; ///< outlives the window, which sends events to it
    Window window_;
    Gui gui_;
    Session session_;
    Ui ui_;
    CanvasMouse mouse_;
    gl::Framebuffer picture_ = gl::Framebuffer::create(); ///< to read pictures of the other context
    static constexpr glm::dvec2 nowhere{-1e6};
    glm::dvec2 mouse_place_ = nowhere;
    std::array<bool, 5> buttons_{};
    bool shift_ = false;
    std::chrono::steady_clock::time_point drawn_ = std::chrono::steady_clock::now();
    int frames_due_ = 0; ///< ImGui needs more than one frame to come to rest after an event
    std::uint64_t frames_shown_ = 0;
    float scale_ = 0, pixels_per_point_ = 0;
    std::size_t letters_ = 0;    ///< number of letters that fonts were made for
    Theme theme_ = Theme::light; ///< the theme that was applied
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace lineatlas::viewer
