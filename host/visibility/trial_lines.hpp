#pragma once

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// What devices are tried with (compute/opencl/device_trial.hpp): boxes that hide one another.
LineSet trial_lines();

/// How it is looked at.
Camera trial_camera(const LineSet& lines);

} // namespace lineatlas
