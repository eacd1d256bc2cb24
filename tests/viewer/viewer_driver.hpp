#pragma once

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "lineatlas/io.hpp"
#include "viewer/window/application.hpp"

namespace lineatlas::test {

/// Operates the viewer. Its events enter at the same place as those of GLFW, so that handlers,
/// panels and pictures are the real ones. Only X and GLFW are left out, because their events of a
/// mouse depend on other programs on a display without a window manager.
class ViewerDriver {
  public:
    explicit ViewerDriver(viewer::Application& application) : app_(application) {}

    viewer::Session& session() { return app_.session(); }

    /// Shows frames, each with a new picture.
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            session().changed();
            panel_frames(1);
        }
    }
    /// Shows frames without a new picture, which take little time.
    void panel_frames(int count) {
        for (int i = 0; i < count; ++i) {
            app_.input().on_refresh();
            app_.step(0);
        }
    }
    /// Shows frames until nothing changes any more. Throws if that does not come.
    void rest() {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point end = Clock::now() + std::chrono::minutes{5};
        while (Clock::now() < end) {
            const std::uint64_t before = app_.frames_shown();
            app_.step(session().loader.busy() || session().drawing() ? 0.05 : 0);
            const bool busy = session().loader.busy() || session().drawing() ||
                              session().navigation.gliding() || session().recording().has_value();
            if (!busy && app_.frames_shown() == before) return;
        }
        throw std::runtime_error{"the viewer does not come to rest"};
    }
    void open_scene(const char* name) {
        session().open_scene(name);
        rest();
    }

    void key(int code, int mods = 0) {
        press(code, mods);
        release(code);
        rest();
    }
    void press(int code, int mods = 0) { app_.input().on_key(code, 0, GLFW_PRESS, mods); }
    void release(int code) { app_.input().on_key(code, 0, GLFW_RELEASE, 0); }
    void move(glm::dvec2 place) {
        app_.input().on_mouse_move(place);
        rest();
    }
    void drag(int button, glm::dvec2 from, glm::dvec2 to, int mods = 0) {
        move(from);
        app_.input().on_mouse_button(button, GLFW_PRESS, mods);
        rest();
        move(0.5 * (from + to));
        move(to);
        app_.input().on_mouse_button(button, GLFW_RELEASE, mods);
        rest();
    }
    void scroll(double clicks, glm::dvec2 place) {
        move(place);
        app_.input().on_scroll({0, clicks});
        rest();
    }
    /// The place in the window of a place in the picture, which begins below the tool bar. Both in
    /// points.
    glm::dvec2 in_window(glm::dvec2 of_picture) const {
        return of_picture + glm::dvec2{viewer::canvas_area(app_.ui(), app_.window().points()).low};
    }
    /// The same for shares of the picture's width and height.
    glm::dvec2 at_shares(glm::dvec2 shares) {
        return in_window(shares * glm::dvec2{session().size()});
    }
    glm::dvec2 middle_of(const std::string& spot) {
        const std::optional<viewer::Area> area = app_.ui().spots.find(spot);
        if (!area) throw std::runtime_error{"the window has no \"" + spot + "\""};
        return area->low + 0.5F * area->size;
    }
    bool has(const std::string& spot) const { return app_.ui().spots.find(spot).has_value(); }
    /// Scrolls the sidebar until an item of it is in sight.
    void reveal(const std::string& spot) {
        constexpr double top = 30,
                         bottom = 540; // below the edge, above the footer of a fine display
        const double x = app_.window().points().x - 100;
        for (int i = 0; i < 100; ++i) {
            const glm::dvec2 place = middle_of(spot);
            const bool footer = spot == "export" || spot == "save.session";
            if (place.x < session().size().x || footer || (place.y > top && place.y < bottom))
                return;
            scroll(place.y > bottom ? -1 : 1, {x, 0.5 * bottom});
            // At the end of the sidebar the last items are above the footer.
            const bool at_end = middle_of(spot) == place;
            if (at_end && place.y > top && place.y < app_.window().points().y) return;
        }
        throw std::runtime_error{"\"" + spot + "\" does not come in sight, but stands at " +
                                 std::to_string(middle_of(spot).y)};
    }
    void click(const std::string& spot) {
        rest();
        if (spot.find('/') == std::string::npos) reveal(spot);
        const glm::dvec2 place = middle_of(spot);
        drag(GLFW_MOUSE_BUTTON_LEFT, place, place);
    }
    void choose(const std::string& list, const std::string& item) {
        click(list);
        click(list + "/" + item);
    }
    void type(const std::string& text) {
        for (const char letter : text) {
            app_.input().on_character(static_cast<unsigned char>(letter));
            panel_frames(2);
        }
    }
    /// Saves like the command of that kind.
    void save(viewer::SavedKind kind) {
        viewer::save_as(app_.ui(), kind);
        panel_frames(1);
        rest();
    }
    void drop(const std::filesystem::path& file) {
        app_.input().on_drop({file});
        rest();
    }

    /// A picture of the window. It is also saved in the folder that LINEATLAS_SCREENSHOTS names.
    Image screenshot(const std::string& name) {
        Image image = app_.screenshot();
        if (const char* folder = std::getenv("LINEATLAS_SCREENSHOTS")) {
            write_image(std::filesystem::path{folder} / (name + ".png"), image);
        }
        return image;
    }

  private:
    viewer::Application& app_;
};

} // namespace lineatlas::test
