#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segment_table.h"

namespace lineatlas {

/// Some neighbouring segments of a table.
struct SegmentRange {
    std::uint32_t first, count;
};

/// Cuts a table of segments into chunks of whole paths, because a segment needs only the segments
/// of its own path. A chunk has at most `usual` segments, or is one longer path. An empty table
/// gives one empty chunk.
std::vector<SegmentRange> cut_segments(std::span<const Segment> segments, std::uint64_t usual);

} // namespace lineatlas
