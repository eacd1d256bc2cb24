#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lineatlas/lines.hpp"
#include "segment_table.h"

namespace lineatlas {

/// The order of a frame's segments, in which silhouettes stand in chains (kernels/chain.cl) in
/// place of the line set's candidates. Brings results of a frame back into the order, and the
/// direction, of LineSet::segments.
struct TableOrder {
    std::uint32_t first = 0;            ///< the first segment that is a silhouette
    std::vector<std::uint32_t> origins; ///< where the silhouettes come from, see chain_write

    /// The segment of the line set that a segment of the frame is, numbered within the chunk.
    std::uint32_t source(std::uint32_t segment) const {
        return segment < first ? segment : first + ((origins[segment - first] - 1) >> 1U);
    }
    /// Whether a segment of the frame runs the other way.
    bool is_reversed(std::uint32_t segment) const {
        return segment >= first && ((origins[segment - first] - 1) & 1U) != 0;
    }
    /// `offsets`: those of the frame's samples; empty if it has none, as in the exact method.
    void restore(std::vector<Interval>& intervals, std::span<const std::uint32_t> offsets) const;
    void restore(std::vector<Run>& runs) const;
    void restore(std::vector<OutlinePart>& parts) const;
    /// Restores the samples of all segments, and where the samples of each begin. `segments`: the
    /// number of segments of the line set.
    void restore(std::uint32_t segments, std::vector<std::uint32_t>& offsets,
                 std::vector<std::uint8_t>& samples) const;
};

} // namespace lineatlas
