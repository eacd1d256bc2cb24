#include "canvas_mouse.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <GLFW/glfw3.h>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

namespace lineatlas::viewer {
namespace {

constexpr double dolly_per_click = 0.88;
constexpr double dolly_per_height = 0.05;  ///< factor of the distance for a drag over the canvas
constexpr double flight_per_second = 0.35; ///< of the model's diagonal
constexpr double fast_factor = 4;
constexpr double click_reach = 3; // points
constexpr double double_click_seconds = 0.4;

/// The way of each key: to the right, upwards, ahead.
const std::map<int, glm::dvec3>& ways() {
    static const std::map<int, glm::dvec3> ways{{GLFW_KEY_W, {0, 0, 1}}, {GLFW_KEY_S, {0, 0, -1}},
                                                {GLFW_KEY_D, {1, 0, 0}}, {GLFW_KEY_A, {-1, 0, 0}},
                                                {GLFW_KEY_E, {0, 1, 0}}, {GLFW_KEY_Q, {0, -1, 0}}};
    return ways;
}

} // namespace

CanvasMouse::Drag CanvasMouse::drag_of(int button, int mods) {
    if (button == GLFW_MOUSE_BUTTON_MIDDLE) return Drag::pan;
    if (button == GLFW_MOUSE_BUTTON_RIGHT) return Drag::look;
    if ((mods & GLFW_MOD_SHIFT) != 0) return Drag::pan;
    return (mods & GLFW_MOD_CONTROL) != 0 ? Drag::dolly : Drag::orbit;
}

glm::dvec2 CanvasMouse::on_canvas(glm::dvec2 place) const {
    const glm::dvec2 pixels_per_point =
        glm::dvec2{session_.size()} / glm::max(glm::dvec2{area_.size}, 1.0);
    return (place - glm::dvec2{area_.low}) * pixels_per_point;
}

bool CanvasMouse::over_slider(glm::dvec2 place) const {
    if (!session_.settings.split || !area_.holds(place)) return false;
    constexpr double reach = 7; // points
    const double x = area_.low.x + session_.settings.split_at * area_.size.x;
    return std::abs(place.x - x) < reach;
}

std::optional<std::size_t> CanvasMouse::cut_at(glm::dvec2 place) const {
    if (!area_.holds(place)) return {};
    constexpr double reach = 12; // points
    const double pixels_per_point = session_.size().x / std::max<double>(area_.size.x, 1);
    return session_.cut_at(on_canvas(place), reach * pixels_per_point);
}

bool CanvasMouse::over_cut(glm::dvec2 place) const {
    return cut_at(place).has_value();
}

void CanvasMouse::press(int button, int mods, glm::dvec2 place) {
    if (dragging() || !area_.holds(place)) return;
    last_ = pressed_ = place;
    moved_ = false;
    button_ = button;
    mods_ = mods;
    drag_ = over_slider(place) ? Drag::slider : drag_of(button, mods);
    if (const auto cut = cut_at(place); cut && drag_ == Drag::orbit) {
        drag_ = Drag::cut;
        cut_ = *cut;
    }
    if (session_.model() == nullptr) drag_ = Drag::none;
    if (drag_ != Drag::slider) held_ = session_.point_at(on_canvas(place));
}

void CanvasMouse::release(int button, double now) {
    if (button != button_) return;
    const bool clicked =
        drag_ != Drag::cut && drag_ != Drag::slider && drag_ != Drag::none && !moved_;
    drag_ = Drag::none;
    if (!clicked) return;
    if (button == GLFW_MOUSE_BUTTON_LEFT) click(now);
    if (button == GLFW_MOUSE_BUTTON_RIGHT) ask_for_menu();
}

void CanvasMouse::click(double now) {
    const bool twice =
        now - clicked_at_ < double_click_seconds && glm::distance(pressed_, clicked_) < click_reach;
    clicked_ = pressed_;
    clicked_at_ = now;
    if (session_.measuring()) return session_.measure_at(on_canvas(pressed_));
    const bool adds = (mods_ & (GLFW_MOD_CONTROL | GLFW_MOD_SHIFT)) != 0;
    session_.select(session_.part_at(on_canvas(pressed_)), adds);
    if (twice && !adds) session_.frame_selected();
}

/// A menu is about the part under the mouse, or about all selected parts if that part is selected.
void CanvasMouse::ask_for_menu() {
    const std::optional<std::uint32_t> part = session_.part_at(on_canvas(pressed_));
    if (!part || !session_.selected.contains(*part)) session_.select(part);
    menu_at_ = pressed_;
}

void CanvasMouse::move(glm::dvec2 place) {
    if (!dragging()) return;
    moved_ = moved_ || glm::distance(place, pressed_) > click_reach;
    Navigation& navigation = session_.navigation;
    const glm::dvec2 way = (place - last_) / static_cast<double>(std::max(area_.size.y, 1.0F));
    switch (drag_) {
    case Drag::orbit:
        navigation.orbit(held_, -glm::pi<double>() * way);
        break;
    case Drag::look: {
        const double fov = navigation.view().fov_y;
        navigation.look(-fov * way);
        break;
    }
    case Drag::pan:
        navigation.pan(held_, on_canvas(last_), on_canvas(place), session_.size());
        break;
    case Drag::dolly:
        navigation.dolly(held_, std::pow(dolly_per_height, -way.y));
        break;
    case Drag::slider:
        session_.settings.split_at =
            std::clamp((static_cast<float>(place.x) - area_.low.x) / area_.size.x, 0.0F, 1.0F);
        break;
    case Drag::cut:
        session_.drag_cut(cut_, on_canvas(last_), on_canvas(place));
        break;
    case Drag::none:
        break;
    }
    last_ = place;
}

void CanvasMouse::scroll(double clicks, glm::dvec2 place) {
    if (session_.model() == nullptr || !area_.holds(place)) return;
    session_.navigation.dolly(session_.point_at(on_canvas(place)),
                              std::pow(dolly_per_click, clicks));
}

bool CanvasMouse::key(int key, bool down) {
    if (!ways().contains(key)) return false;
    if (down) {
        keys_.insert(key);
        fresh_keys_.insert(key);
        released_keys_.erase(key);
    } else if (fresh_keys_.contains(key)) {
        released_keys_.insert(key); // released once it has moved the camera
    } else {
        keys_.erase(key);
    }
    return true;
}

void CanvasMouse::release_keys() {
    keys_.clear();
    fresh_keys_.clear();
    released_keys_.clear();
}

void CanvasMouse::advance(double seconds, bool fast) {
    if (keys_.empty()) return;
    if (session_.model() == nullptr) return release_keys();
    glm::dvec3 way{0};
    for (const int key : keys_) way += ways().at(key);
    const Bounds& bounds = session_.model()->lines.bounds;
    const double speed = flight_per_second * glm::length(bounds.max - bounds.min);
    session_.navigation.fly(way * (speed * seconds * (fast ? fast_factor : 1)));
    fresh_keys_.clear();
    for (const int key : std::exchange(released_keys_, {})) keys_.erase(key);
}

} // namespace lineatlas::viewer
