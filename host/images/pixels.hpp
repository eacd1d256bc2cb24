#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lineatlas/io.hpp"

namespace lineatlas {

/// Conversions between sRGB-coded pixels and the values of picture files. The last of 2 or 4
/// channels is alpha, which is never sRGB-coded.

/// Throws std::runtime_error for a picture with too many pixels.
void check_pixel_count(std::int64_t width, std::int64_t height);

/// Linear light, colour multiplied by alpha; alpha of `pixels` must be straight.
std::vector<float> to_linear(const Pixels& pixels);

/// From linear light; `multiplied` says whether colour is multiplied by alpha.
std::vector<std::uint8_t> from_linear(std::span<const float> pixels, int channels, bool multiplied);

/// Whether the last channel is alpha.
bool has_alpha(int channels);

/// Divides 8-bit colour by alpha, in place.
void divide_by_alpha(std::span<std::uint8_t> pixels, int channels);

/// Whether alpha, if there is any, is full everywhere.
bool is_opaque(const Pixels& pixels);

/// The values of `pixels`, colour divided by alpha.
std::vector<std::byte> straight(const Pixels& pixels);

/// The values of `pixels`, whose alpha is straight, over white paper and without alpha.
std::vector<std::byte> over_white(const Pixels& pixels);

} // namespace lineatlas
