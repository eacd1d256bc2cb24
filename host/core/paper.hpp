#pragma once

#include <cstdint>
#include <vector>

namespace lineatlas {

/// The surface of drawing paper, one value per pixel of the screen, to be repeated in both
/// directions.
struct PaperTile {
    static constexpr int size = 512; ///< per side; a power of two
    std::vector<std::uint8_t> depth; ///< the darkening of a pixel at full grain; 255 is black
};

/// Rough paper: a fine tooth, uneven pulp and short fibres. The same on every machine.
PaperTile make_paper();

} // namespace lineatlas
