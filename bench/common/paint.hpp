#pragma once

#include "drawing.hpp"
#include "lineatlas/io.hpp"

namespace lineatlas::bench {

/// Draws the picture, 2 pixels per unit.
Image paint(const Drawing& drawing);

/// Throws DeviceError if paint() cannot work because OpenImageIO or its font is missing.
void check_painting();

} // namespace lineatlas::bench
