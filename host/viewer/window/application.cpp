#include "application.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include "theme.hpp"

namespace lineatlas::viewer {
namespace {

constexpr int frames_after_event = 3;

} // namespace

Application::Gui::Gui(GLFWwindow* window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // ImGui must remember nothing
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplGlfw_InitForOpenGL(window, false);
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

Application::Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

Application::Application(const ApplicationOptions& options, ImageWriter& writer)
    : options_(options), window_(options.size, "lineatlas"), gui_(window_.handle()),
      session_(options.device, writer, window_.context(), Window::wake), ui_{session_},
      mouse_(session_) {
    ui_.theme = options.theme.value_or(theme_of_desktop());
    window_.listen(&queue_);
    show_soon();
}

Application::~Application() = default;

void Application::show_soon() {
    frames_due_ = frames_after_event;
}

/// Whether the picture of an older view is shown while a newer one is drawn.
bool Application::shows_moved_picture() const {
    return session_.drawing() && session_.placement().moved;
}

/// Whether a field has the keyboard, or has it from the next frame on.
bool Application::field_has_keyboard() {
    return ImGui::GetIO().WantTextInput || ImGui::GetCurrentContext()->WantTextInputNextFrame == 1;
}

/// Whether a menu or a list to choose from is open.
bool Application::menu_is_open() {
    constexpr ImGuiPopupFlags any = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
    return ImGui::IsPopupOpen(static_cast<const char*>(nullptr), any);
}

/// Whether letters are text and not shortcuts.
bool Application::letters_are_text() const {
    return takes_letters(ui_.panel) || menu_is_open() || field_has_keyboard();
}

/// Shows frames until the field of a panel has the keyboard, so that the field gets typed letters.
void Application::give_keyboard() {
    constexpr int most = 4; // frames that ImGui needs for that
    for (int i = 0; i < most && has_search(ui_.panel) && !field_has_keyboard(); ++i) make_frame();
}

/// Passes events to the interface one by one, with a frame without pictures for each. Otherwise a
/// key that goes down and up within a frame would be missed, and letters would come before their
/// field. Work that an event asks for is done before the next event.
void Application::take_input() {
    while (!queue_.empty() && !ui_.later) {
        give_keyboard();
        queue_.pass_next_to(*this);
        if (!queue_.empty()) make_frame();
    }
}

void Application::run() {
    while (!window_.should_close()) step(-1);
}

/// Seconds until the picture should become exact; nothing if it should not. A person who scrolls or
/// types goes on soon and should not have to wait for it.
std::optional<double> Application::seconds_to_refine() const {
    const bool idle = frames_due_ == 0 && !mouse_.dragging() && !mouse_.flying() && !ui_.later &&
                      !ImGui::IsAnyMouseDown();
    if (!idle || !session_.can_refine()) return {};
    constexpr double rest = 0.25;
    const std::chrono::duration<double> past = std::chrono::steady_clock::now() - drawn_;
    return options_.scripted ? 0 : std::max(rest - past.count(), 0.0);
}

/// Whether the preview of an export must be drawn anew.
bool Application::shows_preview() const {
    return ui_.panel == Panel::exporting && session_.preview_due();
}

/// Seconds to wait for events. 0: do not wait. Below 0: wait without end.
double Application::seconds_to_wait() const {
    constexpr double smooth = 0.033, soon = 0.1, blinking = 0.4, looking = 1;
    if (session_.drawing() && frames_due_ == 0) return smooth;
    const bool at_work = frames_due_ > 0 || session_.stale() || session_.navigation.gliding() ||
                         session_.recording() || mouse_.flying() || ui_.later || shows_preview();
    if (at_work) return 0;
    if (const std::optional<double> seconds = seconds_to_refine()) return *seconds;
    if (session_.loader.busy()) return smooth;
    if (session_.messages.passing() || session_.timings_due()) return soon;
    if (ImGui::GetIO().WantTextInput) return blinking;
    return session_.has_files_to_look_at() ? looking : -1;
}

void Application::step(double longest_wait) {
    double wait = queue_.empty() ? seconds_to_wait() : 0;
    if (longest_wait >= 0) wait = wait < 0 ? longest_wait : std::min(wait, longest_wait);
    const bool timed = wait > 0;
    window_.wait(wait);
    take_input();
    if (timed) {
        session_.look_at_file();
        session_.look_at_kernels();
    }
    if (timed &&
        (session_.loader.busy() || session_.messages.passing() || ImGui::GetIO().WantTextInput)) {
        frames_due_ = std::max(frames_due_, 1);
    }
    advance();
    session_.record_picture();
    if (const std::optional<double> seconds = seconds_to_refine(); seconds && *seconds <= 0) {
        session_.refine();
    }
    if (ui_.later) frames_due_ = std::max(frames_due_, 1); // which says so
    if (shows_moved_picture() || session_.recording() || !session_.work().empty())
        frames_due_ = std::max(frames_due_, 1);
    if (frames_due_ == 0 && shows_preview()) session_.draw_preview();
    if (frames_due_ == 0 && !session_.stale()) return;
    frames_due_ = std::max(frames_due_ - 1, 0);
    const bool announced = ui_.later.has_value();
    make_frame();
    show_frame();
    if (!announced || !ui_.later) return;
    const auto work = std::move(ui_.later->second);
    ui_.later.reset();
    work();
    show_soon();
}

void Application::advance() {
    const auto now = std::chrono::steady_clock::now();
    constexpr double longest = 0.1; // a slow frame must not make a jump
    const std::chrono::duration<double> past = now - std::exchange(last_, now);
    const double seconds =
        options_.seconds_a_step > 0 ? options_.seconds_a_step : std::min(past.count(), longest);
    const std::size_t messages = session_.messages.all().size();
    const Model* model = session_.model();
    if (session_.take_picture()) note_picture();
    if (session_.take_task()) show_soon();
    mouse_.advance(seconds, shift_);
    session_.advance(seconds);
    if (!ImGui::IsAnyItemActive() && !mouse_.dragging() && !mouse_.flying()) session_.note_step();
    if (model != session_.model())
        window_.set_title(session_.model()->source.name() + " - lineatlas");
    if (messages != session_.messages.all().size() || model != session_.model()) show_soon();
    if (session_.take_timings() && ui_.timings) frames_due_ = std::max(frames_due_, 1);
}

/// Makes letters and panels as large as the display wants them.
void Application::fit_scale() {
    const float scale = options_.scale > 0 ? options_.scale : window_.content_scale();
    const float ratio = window_.pixels_per_point();
    const bool has_letters = ui_.letters.size() == letters_;
    if (scale == scale_ && ratio == pixels_per_point_ && ui_.theme == theme_ && has_letters) return;
    theme_ = ui_.theme;
    letters_ = ui_.letters.size();
    scale_ = ui_.scale = scale;
    pixels_per_point_ = ratio;
    ui_.bold = apply_theme(ui_.theme, scale, ratio, ui_.letters);
#ifndef IMGUI_HAS_TEXTURES // since 1.92 it renews the texture itself
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

Area Application::canvas_area() const {
    return viewer::canvas_area(ui_, window_.points());
}

void Application::make_frame() {
    fit_scale();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    const ImVec2 mouse{static_cast<float>(mouse_place_.x), static_cast<float>(mouse_place_.y)};
#if IMGUI_VERSION_NUM >= 18700 // it has a queue of all input
    io.AddMousePosEvent(mouse.x, mouse.y);
#else
    io.MousePos = mouse;
    std::copy(buttons_.begin(), buttons_.end(), io.MouseDown); // as they were at the event
#endif
    ImGui::NewFrame();
    ui_.spots.begin_frame();
    const glm::vec2 size{window_.points()};
    if (ui_.sidebar) {
        const float width = sidebar_width(ui_);
        draw_sidebar(ui_, {{size.x - width, 0}, {width, size.y}});
    }
    const Area canvas = canvas_area();
    mouse_.set_area(canvas);
    draw_canvas_overlays(ui_, canvas);
    draw_timings(ui_, canvas);
    if (mouse_.take_menu()) ui_.opens_menu = true;
    draw_parts_menu(ui_);
    draw_messages(ui_, canvas);
    draw_help(ui_);
    draw_open_panel(ui_, canvas);
    draw_export_panel(ui_);
    draw_palette(ui_, canvas);
    if (ui_.quit) window_.close();
    if (ui_.letters.size() != letters_) show_soon(); // with the new letters
    session_.profile = ui_.timings;
    if (mouse_.over_slider(mouse_place_) && !io.WantCaptureMouse) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    } else if (mouse_.over_cut(mouse_place_) && !io.WantCaptureMouse) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    ImGui::Render();
}

void Application::show_frame() {
    session_.resize(glm::ivec2{glm::round(canvas_area().size * pixels_per_point_)});
    if (session_.stale()) {
        session_.draw();
        show_soon(); // the status says how it is drawn
        // A fast picture is shown at once. For a slow one the window does not wait.
        constexpr std::chrono::milliseconds short_wait{20}, until_done = std::chrono::hours{1};
        if (session_.take_picture(options_.scripted ? until_done : short_wait)) note_picture();
    }
    paint();
    window_.show_frame();
    ++frames_shown_;
}

/// A new picture is shown.
void Application::note_picture() {
    drawn_ = std::chrono::steady_clock::now();
    frames_due_ = std::max(frames_due_, 1);
    if (session_.timings_due()) session_.take_timings();
}

void Application::paint() const {
    blit_pictures();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

/// Copies the pictures, whole or on either side of the slider, to their place in the window.
void Application::blit_pictures() const {
    const glm::ivec2 window = window_.pixels(), size = session_.size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, window.x, window.y);
    glDisable(GL_SCISSOR_TEST);
    const glm::vec3 paper = session_.settings.style.paper.color;
    glClearColor(paper.x, paper.y, paper.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const bool split = session_.settings.split && session_.picture(1) != nullptr;
    const int border =
        split
            ? static_cast<int>(std::lround(session_.settings.split_at * static_cast<float>(size.x)))
            : size.x;
    const Session::Placement place = session_.placement();
    const auto above =
        static_cast<int>(std::lround(canvas_area().low.y * pixels_per_point_)); // the tool bar
    const glm::ivec2 canvas{0, window.y - size.y - above};
    const glm::ivec2 low = canvas + glm::ivec2{glm::round(place.low)};
    const glm::ivec2 high = canvas + glm::ivec2{glm::round(place.high)};
    const auto blit = [&](std::size_t side, int from, int to) {
        const gl::Canvas* picture = session_.picture(side);
        if (picture == nullptr || from >= to) return;
        glNamedFramebufferTexture(picture_.id(), GL_COLOR_ATTACHMENT0, picture->texture(), 0);
        glScissor(from, canvas.y, to - from, size.y);
        const glm::ivec2 drawn = picture->size();
        glBlitNamedFramebuffer(picture_.id(), 0, 0, 0, drawn.x, drawn.y, low.x, low.y, high.x,
                               high.y, GL_COLOR_BUFFER_BIT,
                               drawn == high - low ? GL_NEAREST : GL_LINEAR);
    };
    glEnable(GL_SCISSOR_TEST);
    blit(0, 0, border);
    blit(1, border, size.x);
    glDisable(GL_SCISSOR_TEST);
}

Image Application::screenshot() const {
    Image image{.size = window_.pixels(), .channels = 3, .pixels = {}};
    const auto row = static_cast<std::size_t>(image.size.x) * 3;
    image.pixels.resize(row * static_cast<std::size_t>(image.size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    // The frame that was shown last is gone with the swap, so it is drawn again and not shown.
    paint();
    glReadPixels(0, 0, image.size.x, image.size.y, GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
    for (std::size_t low = 0, high = image.pixels.size(); low + row < high; low += row) {
        high -= row;
        std::swap_ranges(image.pixels.begin() + static_cast<std::ptrdiff_t>(low),
                         image.pixels.begin() + static_cast<std::ptrdiff_t>(low + row),
                         image.pixels.begin() + static_cast<std::ptrdiff_t>(high));
    }
    return image;
}

} // namespace lineatlas::viewer
