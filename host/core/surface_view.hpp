#pragma once

#include <glm/mat4x4.hpp>

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// How a camera sees planes. Nearness grows towards the eye and is linear on the screen for every
/// plane: 1/w, or 1 - z in a parallel view.
struct SurfaceView {
    /// Of a place on the screen (-1 to 1 in x and y), 1 and nearness: a point of the world,
    /// homogeneous.
    glm::mat4 world_from_screen;
    bool parallel;
    /// Nearness by which a line's own smooth patch may stand before it, times w: it bends into the
    /// way beside its own outline (core/depth_tolerance.hpp).
    float bend;
};

SurfaceView surface_view(const Camera& camera);

} // namespace lineatlas
