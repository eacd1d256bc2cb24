#pragma once

#include <string>

#include "outline.hpp"

namespace lineatlas {

/// A number for XML with at most `digits` digits after the point, and without needless ones.
std::string number_text(double value, int digits);

/// The `d` of a path, rounded to so many digits; empty if it has no length then. Rounded places are
/// exact: relative steps do not add up errors.
std::string path_data(const Outline& outline, int digits, bool relative);

} // namespace lineatlas
