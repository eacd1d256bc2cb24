#pragma once

#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// Throws UsageError for options with which no frame can be drawn, whatever its lines are.
void check(const FrameOptions& options);

} // namespace lineatlas
