#pragma once

namespace lineatlas {

/// Pixels that a millimetre of a sheet takes in the pictures of its views: so many that what is
/// exact to pixels is exact on paper, whatever the size of the page.
constexpr double sheet_pixels = 10;

} // namespace lineatlas
