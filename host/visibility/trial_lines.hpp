#pragma once

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The line set with which devices are tried (compute/opencl/device_trial.hpp): boxes that hide one
/// another.
LineSet trial_lines();

/// The camera that looks at the trial lines.
Camera trial_camera(const LineSet& lines);

} // namespace lineatlas
