#pragma once

#include "lineatlas/style.hpp"

namespace lineatlas {

/// Multiplies every length of a style by a factor, for a picture that has so many times as many
/// pixels a side. The lengths are then those of that picture: Style::made_for is 0.
void multiply_lengths(Style& style, float factor);

} // namespace lineatlas
