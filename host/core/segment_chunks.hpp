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

/// Cuts a table of segments into chunks of whole paths, since a segment needs only those of its
/// path: of at most `usual` segments, or of one path that is longer. Without segments it is one
/// empty chunk.
std::vector<SegmentRange> cut_segments(std::span<const Segment> segments, std::uint64_t usual);

} // namespace lineatlas
