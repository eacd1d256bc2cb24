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

/// A camera as all stages want it, and how depth values of the program's buffer are to be read.
struct StandardCamera {
    Camera camera;
    DepthMapping depth{};
};

/// The same picture by GL's default clip control, with depth that grows away from the eye. Where
/// depth is not what it was, its planes enclose `bounds` as far as the program's own planes let
/// them: that is where an infinite or reversed projection gets its precision from.
StandardCamera standard_camera(const Camera& camera, const Bounds& bounds);

/// The same for depth values that a program has drawn by that camera. Window depth is scaled so
/// that one step of theirs is no more than what the probes take for rounding: a depth buffer of 16
/// bits only blurs what is hidden by less than its step.
StandardCamera standard_camera(const Camera& camera, const Bounds& bounds,
                               const DepthValues& values);

/// Whether all of a box lies beyond the near plane, so that nothing in it is seen from within: of a
/// standard camera.
bool sees_from_outside(const Camera& camera, const Bounds& bounds);

} // namespace lineatlas
