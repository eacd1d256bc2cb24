#pragma once

#include <optional>
#include <span>
#include <string>

#include "cli_fwd.hpp"
#include "lineatlas/camera.hpp"

namespace lineatlas {

/// The camera, as the command line gives it: --eye, --target, --up, --fov,
/// --projection, --view, --views, and --scale with --unit.
class ViewOptions {
  public:
    /// `app` must outlive this object, and this object the parsing.
    void declare(CLI::App& app, const std::string& group);

    /// Throws UsageError for wrong options and for options that contradict each other.
    void check() const;

    bool places_eye() const { return !eye_.empty(); }
    bool to_scale() const { return !scale_.empty(); }
    bool says_up() const { return !up_.empty() && up_ != "auto"; }
    bool says_target() const { return !target_.empty(); }
    bool says_direction() const { return !view_.empty() || is_sheet(); }
    /// Whether --views asks for a sheet, and its value.
    bool is_sheet() const { return !views_.empty(); }
    const std::string& views() const { return views_; }
    const std::string& scale() const { return scale_; } ///< the value of --scale; empty: not given
    /// The value of --projection; for a sheet the angle of projection; empty: not given.
    const std::string& projection_name() const { return projection_; }
    /// Millimetres per unit of the model: as --unit says, or the file, or the default of --unit.
    double unit(std::optional<double> of_file) const;
    glm::vec3 up(glm::vec3 otherwise) const; ///< `otherwise` without --up
    Projection projection() const;

    /// A view of all points, from the side that --view names, or from the front, right and above.
    View framed(std::span<const glm::vec3> points, glm::ivec2 size, glm::vec3 up) const;
    /// Changes the view as the options say. `origin`: that of the view, in the file's coordinates.
    /// `up_is_guessed`: the view's up may change if the camera looks along it.
    void apply(View& view, glm::dvec3 origin, bool up_is_guessed) const;
    /// The view at the scale of --scale. A pixel is `millimetres` on paper. `points`: must all be
    /// in the picture, unless options place the camera. `of_file`: millimetres of the model's unit
    /// if its file says them, in place of the default of --unit. Throws UsageError that names a
    /// scale which fits.
    View scaled(const View& view, double millimetres, glm::ivec2 size,
                std::span<const glm::vec3> points, std::optional<double> of_file) const;

  private:
    float fov() const; ///< radians

    CLI::App* app_ = nullptr;
    std::string eye_, target_, up_ = "auto", projection_, view_, views_, scale_, unit_ = "mm";
    float fov_ = 40;
};

/// An orthographic view at a scale, as in "1:2": a unit of the model is `unit` millimetres long, a
/// pixel of the picture `millimetres` on paper. Throws UsageError that names a scale which fits if
/// some of the `points` would be outside of the picture.
View view_to_scale(const View& view, const std::string& scale, double unit, double millimetres,
                   glm::ivec2 size, std::span<const glm::vec3> points);

} // namespace lineatlas
