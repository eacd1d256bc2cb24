#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lineatlas/lines.hpp"
#include "segment_table.h"

namespace lineatlas {

/// The order of a frame's segments: silhouettes are in chains (kernels/chain.cl) in place of the
/// line set's candidates. Brings results of a frame back into the order, and the direction, of
/// LineSet::segments.
struct TableOrder {
    std::uint32_t first = 0;            ///< segment that is a silhouette
    std::vector<std::uint32_t> origins; ///< of these, as chain_write has them

    /// The segment of the line set, of its chunk, that a segment of the frame is.
    std::uint32_t source(std::uint32_t segment) const {
        return segment < first ? segment : first + ((origins[segment - first] - 1) >> 1U);
    }
    /// Whether that runs the other way.
    bool is_reversed(std::uint32_t segment) const {
        return segment >= first && ((origins[segment - first] - 1) & 1U) != 0;
    }
    /// `offsets`: of the frame's samples; empty if it has none, as of the exact method.
    void restore(std::vector<Interval>& intervals, std::span<const std::uint32_t> offsets) const;
    void restore(std::vector<Run>& runs) const;
    void restore(std::vector<OutlinePart>& parts) const;
    /// Samples of all segments and where those of each begin, of a line set of so many.
    void restore(std::uint32_t segments, std::vector<std::uint32_t>& offsets,
                 std::vector<std::uint8_t>& samples) const;
};

} // namespace lineatlas
