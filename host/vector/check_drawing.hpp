#pragma once

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Throws UsageError for a drawing that no file can hold: a pen or paper with values that no style
/// has, a path whose pen does not exist.
void check_drawing(const VectorDrawing& drawing);

} // namespace lineatlas
