#pragma once

#include <optional>
#include <set>
#include <utility>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "ui.hpp"

namespace lineatlas::viewer {

/// Moves the camera, the split screen's slider and the handles of cuts by the mouse and the keys
/// for flying. Places are in points of the window.
class CanvasMouse {
  public:
    explicit CanvasMouse(Session& session) : session_(session) {}

    void set_area(Area area) { area_ = area; }
    void press(int button, int mods, glm::dvec2 place);
    /// A click without a drag selects the part under the mouse, with Ctrl or Shift in addition to
    /// others. A second click soon after frames the part.
    void release(int button, double now);
    void move(glm::dvec2 place);
    void scroll(double clicks, glm::dvec2 place);
    /// Where a click of the right button asked for a menu. Returned once.
    std::optional<glm::dvec2> take_menu() { return std::exchange(menu_at_, std::nullopt); }
    bool dragging() const { return drag_ != Drag::none; }
    bool over_slider(glm::dvec2 place) const;
    bool over_cut(glm::dvec2 place) const; ///< over the handle of a cut

    /// Takes a key that went down or up. Returns true if it is a key for flying.
    bool key(int key, bool down);
    void release_keys();
    bool flying() const { return !keys_.empty(); }
    void advance(double seconds, bool fast);

  private:
    enum class Drag { none, orbit, pan, dolly, look, slider, cut };
    static Drag drag_of(int button, int mods);
    glm::dvec2 on_canvas(glm::dvec2 place) const; ///< in pixels of the picture
    std::optional<std::size_t> cut_at(glm::dvec2 place) const;
    void click(double now);
    void ask_for_menu();

    Session& session_;
    Area area_{};
    Drag drag_ = Drag::none;
    int button_ = 0, mods_ = 0;
    std::optional<glm::dvec2> menu_at_;
    glm::dvec2 pressed_{0}, last_{0}, clicked_{-1e6};
    bool moved_ = false; ///< the mouse has moved too far for a click
    double clicked_at_ = -1e6;
    std::size_t cut_ = 0; ///< that is dragged
    glm::dvec3 held_{0};  ///< the point of the model where a drag began
    std::set<int> keys_;  ///< that fly
    /// Keys that went down, and up again, since advance().
    std::set<int> fresh_keys_, released_keys_;
};

} // namespace lineatlas::viewer
