#pragma once

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// Throws UsageError for a camera that shows no picture: an empty or too large one, matrices that
/// are not finite or singular.
void check_camera(const Camera& camera);

} // namespace lineatlas
