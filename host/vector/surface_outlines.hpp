#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>

#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "lineatlas/mesh.hpp"
#include "lineatlas/surface.hpp"
#include "seen_ellipse.hpp"

namespace lineatlas {

/// The silhouettes of known surfaces that are circles or ellipses in space, as one view sees them:
/// of spheres, of revolutions seen along their axis and, in parallel views, across it.
class SurfaceOutlines {
  public:
    /// `eye` is Camera::eye(). The surfaces must outlive this.
    SurfaceOutlines(const KnownSurfaces& surfaces, glm::dvec4 eye,
                    const glm::dmat4& clip_from_world, glm::dvec2 size)
        : surfaces_(surfaces), eye_(eye), clip_from_world_(clip_from_world), size_(size) {}

    /// The silhouette of a surface from one place to another. Null if the silhouette is no circle
    /// or ellipse, or is seen edge on. The result lives as long as this object.
    const Ellipse* between(std::uint32_t surface, glm::dvec3 from, glm::dvec3 to);

  private:
    const Ellipse* of_sphere(std::uint32_t surface);
    const Ellipse* around_axis(const SurfaceShape& shape, const glm::dmat4x3& placed,
                               glm::dvec3 place);
    const Ellipse* along_meridian(const SurfaceShape& shape, const glm::dmat4x3& placed,
                                  glm::dvec3 from, glm::dvec3 to);
    std::optional<EdgeCurve> sphere_outline(const SurfaceShape& shape,
                                            const glm::dmat4x3& placed) const;
    std::optional<Ellipse> seen(const EdgeCurve& curve) const;
    const Ellipse* kept(const EdgeCurve& curve);

    const KnownSurfaces& surfaces_;
    glm::dvec4 eye_;
    glm::dmat4 clip_from_world_;
    glm::dvec2 size_;                                         ///< of the picture, pixels
    std::map<std::uint32_t, std::optional<Ellipse>> spheres_; ///< by number of the surface
    std::deque<Ellipse> of_revolutions_;
};

} // namespace lineatlas
