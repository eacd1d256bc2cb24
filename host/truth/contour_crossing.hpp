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
    bool on_known_surface; ///< false: normals of corners give its place
    /// Whether the surface shows its front on the side of the eye. If not, a solid hides its own
    /// silhouette.
    bool shows_front;
    /// The direction away from the surface beside its silhouette, of length 1: along the normal if
    /// the surface shows its front, else against it.
    glm::dvec3 beyond;
};

/// Finds the silhouette of a smooth surface within one triangle, as the truth does: by the signs of
/// n.v at the corners (on known surfaces those of the surface itself) and by halving between them.
/// Other triangles stand for the surface that their corners' normals span. `face`: index into
/// Contours::faces.
std::optional<ContourCrossing>
contour_crossing(const LineSet& lines, const PreciseCamera& projection, std::uint32_t face);

} // namespace lineatlas
