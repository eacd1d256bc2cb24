#pragma once

#include <optional>
#include <span>
#include <string>

#include <CLI/App.hpp>

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// The camera, as the command line gives it: --eye, --target, --up, --fov,
/// --projection, --view, --views, and --scale with --unit.
class ViewOptions {
  public:
    /// Both live as long as each other.
    void declare(CLI::App& app, const std::string& group);

    /// Throws UsageError for what can't be or contradicts itself.
    void check() const;

    bool places_eye() const { return !eye_.empty(); }
    bool to_scale() const { return !scale_.empty(); }
    bool says_up() const { return !up_.empty() && up_ != "auto"; }
    bool says_target() const { return !target_.empty(); }
    bool says_direction() const { return !view_.empty() || is_sheet(); }
    /// Whether --views asks for a sheet, and as it has them.
    bool is_sheet() const { return !views_.empty(); }
    const std::string& views() const { return views_; }
    const std::string& scale() const { return scale_; } ///< as --scale has it; empty: not given
    /// As --projection has it, of a sheet the angle of projection; empty: not given.
    const std::string& projection_name() const { return projection_; }
    /// Millimetres in a unit of the model: as --unit says, or its file, or by --unit's default.
    double unit(std::optional<double> of_file) const;
    glm::vec3 up(glm::vec3 otherwise) const; ///< `otherwise` where --up says none
    Projection projection() const;

    /// From the side that --view names, else from the front, right and above.
    View framed(std::span<const glm::vec3> points, glm::ivec2 size, glm::vec3 up) const;
    /// Changes what options say otherwise. `origin`: of the view, in the file's coordinates.
    /// `up_is_guessed`: the view's may turn where one looks along it.
    void apply(View& view, glm::dvec3 origin, bool up_is_guessed) const;
    /// The view to the scale that --scale asks for, if a pixel is `millimetres` on paper. `points`:
    /// must all be in the picture, unless the options place the camera themselves. Throws
    /// UsageError that names a scale which fits. `of_file`: millimetres of the model's unit where
    /// its file says it, in place of --unit's own default.
    View scaled(const View& view, double millimetres, glm::ivec2 size,
                std::span<const glm::vec3> points, std::optional<double> of_file) const;

  private:
    float fov() const; ///< radians

    CLI::App* app_ = nullptr;
    std::string eye_, target_, up_ = "auto", projection_, view_, views_, scale_, unit_ = "mm";
    float fov_ = 40;
};

/// An orthographic view at a scale, as in "1:2": a unit of the model is `unit` millimetres long, a
/// pixel of the picture `millimetres` on paper. Throws UsageError that names a scale which fits
/// where some of the `points` would be outside of the picture.
View view_to_scale(const View& view, const std::string& scale, double unit, double millimetres,
                   glm::ivec2 size, std::span<const glm::vec3> points);

} // namespace lineatlas
