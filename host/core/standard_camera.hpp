#pragma once

#include <glm/vec2.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// The meaning of the values of a program's depth buffer.
struct DepthValues {
    int bits = 32;
    bool floating = true;  ///< else fixed point
    glm::vec2 range{0, 1}; ///< of the near and the far plane (glDepthRange)
};

/// From a program's depth values to window depth: (value - reference) * scale.
struct DepthMapping {
    float reference = 0, scale = 1;
};

/// A camera for all stages, and the mapping of depth values in the program's buffer.
struct StandardCamera {
    Camera camera;
    DepthMapping depth{};
};

/// The same picture by GL's default clip control, with depth that grows away from the eye. If depth
/// has to change, the new planes enclose `bounds` within the program's own planes. So an infinite
/// or reversed projection keeps its precision.
StandardCamera standard_camera(const Camera& camera, const Bounds& bounds);

/// The same for depth values that a program has drawn by that camera. Window depth is scaled so
/// that one step of the values is no larger than the rounding that the probes allow for. A depth
/// buffer of 16 bits only blurs surfaces that are hidden by less than its step.
StandardCamera standard_camera(const Camera& camera, const Bounds& bounds,
                               const DepthValues& values);

/// True if all of a box lies beyond the near plane of a standard camera. Then nothing in the box is
/// seen from within.
bool sees_from_outside(const Camera& camera, const Bounds& bounds);

} // namespace lineatlas
