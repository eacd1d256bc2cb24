#pragma once

#include "images/image_module.hpp"

namespace lineatlas {

/// The module for pictures, loaded when first asked for: lineatlas-images where it is installed,
/// else lineatlas-png. Throws FileError if it cannot be.
const images::Module& image_module();

/// Throws FileError unless one of the two is where it should be. Loads nothing.
void check_image_module();

} // namespace lineatlas
