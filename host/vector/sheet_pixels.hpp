#pragma once

namespace lineatlas {

/// Pixels per millimetre of a sheet in the pictures of its views: so many that an error of pixels
/// is small on paper, whatever the size of the page.
constexpr double sheet_pixels = 10;

} // namespace lineatlas
