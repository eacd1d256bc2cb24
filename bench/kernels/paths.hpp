#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "common.hpp"
#include "segment_table.h"

namespace lineatlas::bench {

/// What `temporal`, `intervals`, `compact` and `filter` work on: n segments in paths of 64. As in a
/// frame most have no samples: two paths of three are hidden whole. Those of the third have 1 to 7
/// samples each, in visible runs of 1 to 39.
struct Paths {
    static constexpr glm::vec2 viewport{1024, 768};

    std::vector<Segment> segments;
    std::vector<ClippedSegment> clipped;
    std::vector<std::uint32_t> offsets, arcs;
    std::vector<std::uint8_t> alpha;
    std::vector<std::uint32_t> runs; ///< the segment of each visible run
};

Paths make_paths(std::uint32_t n);

/// Their tables on a device.
struct PathTables {
    PathTables(compute::Device& device, const Paths& paths);

    compute::SegmentTable table() const { return {*vertices, *vertices, *segments, 0, count}; }
    compute::SegmentAtlas atlas() const { return {{*clipped, *offsets, *arcs}, *alpha, samples}; }

    std::uint32_t count, samples, runs; ///< segments, and what they have
    SharedBuffer vertices, segments, clipped, offsets, arcs, alpha;
};

/// Room for their visible runs, and the record of a frame.
struct RunTables {
    RunTables(compute::Device& device, std::uint32_t capacity);

    /// The runs that a stage has written. Throws Error if there were more than it has room for.
    std::vector<Run> read(compute::Device& device) const;

    std::uint32_t capacity;
    SharedBuffer runs, record;
};

/// The visible runs of the paths, by `compact`.
void compact(compute::Stages& stages, const PathTables& paths, const RunTables& to);

} // namespace lineatlas::bench
