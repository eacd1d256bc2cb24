#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

/// @file
/// Pictures in memory.
/// @code{.cpp}
/// const Image grey{.size = {1, 2}, .channels = 1, .pixels = {0, 255}}; // black over white
/// renderer.set_pen_image("./chalk.png", grey);
/// @endcode

namespace lineatlas {

/// 8-bit pixels, rows from top to bottom, `channels` interleaved values per pixel: grey, grey and
/// alpha, RGB, or RGB and alpha. Colour is sRGB-coded and not multiplied by alpha, as in PNG files.
struct Image {
    glm::ivec2 size{0, 0};              ///< width and height
    int channels = 4;                   ///< 1 to 4
    std::vector<std::uint8_t> pixels{}; ///< size.x * size.y * channels values
};

} // namespace lineatlas
