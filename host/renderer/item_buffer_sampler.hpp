#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frame.hpp"
#include "glpasses/item_buffer_pass.hpp"
#include "segment_table.h"

namespace lineatlas {

/// Visibility by an item buffer, for the methods that Table 1 compares the segment atlas with. The
/// lines of a frame are drawn with an ID each, the picture is read back, and the host walks every
/// line over it.
///
/// Low (`probes` = 1): Northrup & Markosian, "Artistic Silhouettes: A Hybrid Approach", NPAR 2000.
/// One layer at the size of the picture. A sample is visible if its line's ID stands at its pixel,
/// or at the pixel beside that across the line: the raster may place a line one pixel beside the
/// host's walk. Lines hide each other, as in every item buffer with one layer.
///
/// High (`probes` > 1): Cole & Finkelstein, "Partial Visibility for Stylized Lines", NPAR 2008.
/// Supersampled by `probes`, three layers by peeling. A line is one pixel wide there; a sample's
/// visibility is the share of the texels under its piece of the line that hold its ID in any layer.
/// The full number of texels is the width of the line in each texel column along that piece.
///
/// In both, the ends of lines are moved along them by less than a texel, so that the diamond-exit
/// rule leaves no gap between lines that follow each other, and even a line shorter than a texel
/// covers one.
class ItemBufferSampler {
  public:
    /// The segments of a frame.
    struct Lines {
        std::vector<ClippedSegment> clipped; ///< valid where a segment has samples
        std::vector<std::uint32_t> offsets;  ///< first sample of each segment, then the total

        std::uint32_t samples(std::size_t i) const { return offsets[i + 1] - offsets[i]; }
    };
    /// What sample() looks at, to be filled before it.
    Lines& lines() { return lines_; }
    /// The visibility of all samples of the frame, a byte each. Valid until the next call.
    std::span<const std::uint8_t> sample(const Frame& frame);

  private:
    void fill_lines(glm::ivec2 size);
    void walk(const gl::ItemImages& images);

    gl::ItemBufferPass pass_;
    // Kept for their memory.
    Lines lines_;
    std::vector<std::uint8_t> alpha_;
};

} // namespace lineatlas
