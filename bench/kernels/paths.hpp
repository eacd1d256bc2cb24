#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "segment_table.h"

namespace lineatlas::bench {

/// What `compact_runs` and `intervals` work on: n segments in paths of 64. As in a frame most have
/// no samples: two paths of three are hidden whole. Those of the third have 1 to 7 samples each,
/// visible in stretches of 1 to 39.
struct Paths {
    static constexpr glm::vec2 viewport{1024, 768};

    std::vector<Segment> segments;
    std::vector<ClippedSegment> clipped;
    std::vector<std::uint32_t> offsets, arcs;
    std::vector<std::uint8_t> alpha;
    std::vector<std::uint32_t> runs; ///< the segment of each visible run
};

Paths make_paths(std::uint32_t n);

} // namespace lineatlas::bench
