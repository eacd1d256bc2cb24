#pragma once

#include <cstdint>

#include "lineatlas/renderer.hpp" // for its choices alone

namespace lineatlas {

/// The mapping of sample s to a texel, eq. 2. Texels are counted row by row.
struct AtlasLayout {
    std::uint32_t width; ///< w: texels of a row at which a segment can start
    std::uint32_t pitch; ///< W: texels per row

    std::uint32_t address(std::uint32_t s) const { return s / width * pitch + s % width; }
    /// Rows that hold `samples` samples.
    std::uint32_t rows(std::uint32_t samples) const {
        return samples / width + (samples % width != 0 ? 1 : 0);
    }
    std::uint64_t texels(std::uint32_t samples) const {
        return std::uint64_t{rows(samples)} * pitch;
    }
};

/// A layout for segments of up to `longest` samples, with rows no longer than `largest_row` texels.
/// Throws UsageError if they can't be held: the sample step is too fine for the picture size.
AtlasLayout make_atlas_layout(AtlasLayoutChoice choice, std::uint32_t longest,
                              std::uint32_t largest_row);

} // namespace lineatlas
