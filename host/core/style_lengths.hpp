#pragma once

#include "lineatlas/style.hpp"

namespace lineatlas {

/// Makes every length of a style so many times as long, as a picture needs it that has so many
/// times as many pixels a side. They are those of that picture then: Style::made_for is 0.
void multiply_lengths(Style& style, float factor);

} // namespace lineatlas
