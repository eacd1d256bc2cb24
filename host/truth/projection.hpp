#pragma once

#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// A camera in double precision, because float depths are too coarse for rays. It has GL's default
/// clip control, and depth is not reversed.
struct PreciseCamera {
    glm::dmat4 clip_from_world, world_from_clip;
    glm::dvec2 viewport;            ///< pixels
    glm::dvec4 eye;                 ///< w is 0 for a parallel projection
    glm::dvec4 near_plane;          ///< (n, d): n·p + d is negative before the near plane
    double pixel_rate;              ///< world size of a pixel per clip-space w
    double farthest_toward_eye = 0; ///< of the bounds, for a parallel projection

    /// Everything that may hide a line lies within `bounds`.
    PreciseCamera(const Camera& camera, const Bounds& bounds);

    /// Where the sight of a point starts, before everything that may hide it.
    glm::dvec3 start_of_sight(const glm::dvec3& point) const;
    /// Pixels from the upper left corner of the picture, y down. For w > 0.
    glm::dvec2 picture(const glm::dvec4& clip) const;
};

/// The way from the eye to a point on a line or beside it.
struct Sight {
    glm::dvec3 origin, end;
    glm::dvec3 spine; ///< the point of the line itself
    double pixel;     ///< world size of a pixel there
};

/// A part of a straight line as a camera sees it. `u` is the share of the way from its one end to
/// the other on the screen, 0 to 1.
class SeenLine {
  public:
    /// The part from t0 to t1 of the way from p to q. All of it must be before the eye.
    SeenLine(const PreciseCamera& projection, const glm::dvec3& p, const glm::dvec3& q, double t0,
             double t1);

    double length() const { return length_; }                              ///< pixels
    glm::dvec2 at(double u) const { return start_ + (end_ - start_) * u; } ///< as picture()
    glm::dvec2 direction() const { return direction_; } ///< in the picture, unit length
    /// Whether a direction in space points to the left of it in the picture, from its middle.
    bool is_left(const glm::dvec3& way) const;
    /// The sight to a point `across` pixels to the left of the place `u`, at the line's own depth.
    Sight sight(double u, double across) const;

  private:
    const PreciseCamera& projection_;
    glm::dvec4 p_, q_; ///< clip space
    glm::dvec2 start_, end_;
    glm::dvec2 direction_;
    double length_;
};

/// Shares of the way from p to q.
struct LinePart {
    double t0, t1;
};

/// The part of a line in the frustum; nothing if that is empty or a point.
std::optional<LinePart> part_inside(const PreciseCamera& projection, const glm::dvec3& p,
                                    const glm::dvec3& q);

} // namespace lineatlas
