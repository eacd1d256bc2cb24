#pragma once

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Throws UsageError for a drawing that no file can hold: a pen or paper of values that no style
/// has, a path whose pen there is not.
void check_drawing(const VectorDrawing& drawing);

} // namespace lineatlas
