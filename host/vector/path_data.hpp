#pragma once

#include <string>

#include "outline.hpp"

namespace lineatlas {

/// A number for XML with at most `digits` digits after the point, and without needless ones.
std::string number_text(double value, int digits);

/// The attribute `d` of a path with places rounded to `digits`; empty if the rounded path has no
/// length. Relative commands start from rounded places, so errors do not add up.
std::string path_data(const Outline& outline, int digits, bool relative);

} // namespace lineatlas
