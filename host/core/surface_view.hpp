#pragma once

#include <glm/mat4x4.hpp>

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// The view of a camera onto planes. Nearness is 1/w, or 1 - z in a parallel view. It grows towards
/// the eye and is linear on the screen for every plane.
struct SurfaceView {
    /// Turns x and y on the screen (-1 to 1), 1 and nearness into a homogeneous point of the world.
    glm::mat4 world_from_screen;
    bool parallel;
    /// The nearness, times w, by which a line's own smooth patch may stand before the line. A patch
    /// bends before its own outline (core/depth_tolerance.hpp).
    float bend;
};

SurfaceView surface_view(const Camera& camera);

} // namespace lineatlas
