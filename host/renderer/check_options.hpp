#pragma once

#include "lineatlas/renderer.hpp"

namespace lineatlas {

/// Throws UsageError for options that no frame can be drawn with, whatever is drawn.
void check(const FrameOptions& options);

} // namespace lineatlas
