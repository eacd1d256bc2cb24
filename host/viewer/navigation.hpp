#pragma once

#include <optional>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/ray.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::viewer {

/// The line of sight through a point of a picture of `size`, counted from its upper left corner. It
/// begins at the eye, or with parallel lines of sight far behind the eye.
Ray ray_at(const View& view, glm::dvec2 point, glm::dvec2 size);

/// Where a point of the model is seen; nothing for one behind a perspective view's eye.
std::optional<glm::dvec2> seen_at(const View& view, glm::dvec3 point, glm::dvec2 size);

/// The point where the ray first meets a triangle.
std::optional<glm::dvec3> pick(const LineSet& lines, const Ray& ray);

/// The place of the model at a point of a picture: a corner of the triangle there if one is seen
/// within a few pixels, else the point of the triangle.
std::optional<glm::dvec3> corner_or_point(const LineSet& lines, const View& view, glm::dvec2 point,
                                          glm::dvec2 size);

enum class StandardView { front, back, left, right, top, bottom, corner };

/// Unit vector from the model to the eye. The model's front is -y if z is up, else z.
glm::vec3 direction_to(StandardView view, glm::vec3 up);

/// How a person moves a camera around. Whatever is dragged follows the mouse exactly; jumps from
/// one view to another glide.
class Navigation {
  public:
    const View& view() const { return view_; }
    /// The view at the end of a glide; without a glide the current view.
    const View& goal() const { return glide_ ? glide_->to : view_; }

    void set_view(const View& view); ///< at once
    void glide_to(const View& view);
    /// Changes the projection. Things at the target stay as large as they are.
    void set_projection(Projection projection);
    bool gliding() const { return glide_.has_value(); }
    /// Goes on with a glide.
    void advance(double seconds);

    /// Turns about a point of the model, which stays where it is seen. turn: radians about the
    /// vertical, then up and down as far as the vertical allows.
    void orbit(glm::dvec3 pivot, glm::dvec2 turn);
    /// Turns about the eye.
    void look(glm::dvec2 turn);
    /// Moves so that things seen at `from`, as far away as `held`, are seen at `to`.
    void pan(glm::dvec3 held, glm::dvec2 from, glm::dvec2 to, glm::dvec2 size);
    /// Goes towards a point until its distance is `factor` times the old one. The point stays where
    /// it is seen. A factor above 1 goes away, by no less than if the point were as far as the
    /// target.
    void dolly(glm::dvec3 to, double factor);
    /// Moves by distances to the right, upwards and ahead.
    void fly(glm::dvec3 way);

  private:
    struct Glide {
        View from, to;
        double done = 0;
    };
    void turn_about(glm::dvec3 pivot, glm::dvec2 turn);
    void move(glm::dvec3 way);
    void place(glm::dvec3 eye, glm::dvec3 target);

    View view_{};
    std::optional<Glide> glide_;
};

} // namespace lineatlas::viewer
