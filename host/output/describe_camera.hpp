#pragma once

#include <string>

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// A camera as options of `lineatlas draw`: --eye, --target, --up and --fov. One line. `origin`:
/// origin of the camera's world, in the file's coordinates.
std::string describe_camera(const Camera& camera, glm::dvec3 origin = glm::dvec3{0});

} // namespace lineatlas
