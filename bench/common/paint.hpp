#pragma once

#include "drawing.hpp"
#include "lineatlas/io.hpp"

namespace lineatlas::bench {

/// The pixels of a drawing, 2 per unit.
Image paint(const Drawing& drawing);

/// Throws DeviceError where `paint` can't: without OpenImageIO or its font.
void check_painting();

} // namespace lineatlas::bench
