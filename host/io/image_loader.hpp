#pragma once

#include "images/image_module.hpp"

namespace lineatlas {

/// The module for pictures, loaded when first asked for. Throws FileError if it cannot be.
const images::Module& image_module();

/// Throws FileError unless the module is where it should be. Loads nothing.
void check_image_module();

} // namespace lineatlas
