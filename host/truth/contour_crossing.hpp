#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "lineatlas/lines.hpp"
#include "projection.hpp"

namespace lineatlas {

/// Where a smooth surface turns away from the eye within one triangle: the straight line between
/// the places of two of its sides.
struct ContourCrossing {
    glm::dvec3 from, to;
    bool on_known_surface; ///< else normals of corners say where it is
    /// Towards the eye the surface shows its front: else it hides its own silhouette, if it is a
    /// solid's.
    bool shows_front;
    /// Where the surface is not, beside its silhouette: along its normal where it shows its front,
    /// else against it. As long as 1.
    glm::dvec3 beyond;
};

/// How the truth finds silhouettes of smooth surfaces: by signs of n.v at the corners of triangles,
/// on known surfaces those of the surface itself, and halving between them. Other triangles are
/// taken for the surface that their corners' normals span. `face`: index into Contours::faces.
std::optional<ContourCrossing>
contour_crossing(const LineSet& lines, const PreciseCamera& projection, std::uint32_t face);

} // namespace lineatlas
