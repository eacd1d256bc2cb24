#pragma once

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// The window depth, times w, by which a surface or line must be nearer than another line to count
/// as before it.
float depth_tolerance(const Camera& camera);

} // namespace lineatlas
