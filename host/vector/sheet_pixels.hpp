#pragma once

namespace lineatlas {

/// Pixels per millimetre of a sheet in the pictures of its views. An error of some pixels is small
/// on paper then, whatever the size of the page.
constexpr double sheet_pixels = 10;

} // namespace lineatlas
