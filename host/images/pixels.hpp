#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lineatlas/io.hpp"

namespace lineatlas {

/// Conversions between the 8-bit, sRGB-coded, straight-alpha pixels of an Image and what picture
/// files hold. The last of 2 or 4 channels is alpha, which is never sRGB-coded.

/// Linear light, colour multiplied by alpha.
std::vector<float> to_linear(const Image& image);

/// From linear light; `multiplied` says whether colour is multiplied by alpha.
std::vector<std::uint8_t> from_linear(std::span<const float> pixels, int channels, bool multiplied);

/// Divides 8-bit colour by alpha, in place.
void divide_by_alpha(std::span<std::uint8_t> pixels, int channels);

/// Without alpha, over white paper. An image without alpha comes back as it is.
Image over_white(const Image& image);

} // namespace lineatlas
