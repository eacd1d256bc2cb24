#pragma once

#include "lineatlas/device_options.hpp"

namespace lineatlas {

/// Draws frames of a few pixels with whatever kernels frames have, on a device by these options. In
/// the current GL context, of which they leave nothing behind.
void draw_trial_frames(const DeviceOptions& options);

} // namespace lineatlas
