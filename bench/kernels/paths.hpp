#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "common.hpp"
#include "segment_table.h"

namespace lineatlas::bench {

/// The input of stages that work on paths: n segments in paths of 64. As in a frame, most segments
/// have no samples: two paths of three are wholly hidden. Segments of the other paths have 1 to 7
/// samples each. Along these paths 1 to 39 visible samples and 1 to 39 hidden samples take turns.
struct Paths {
    static constexpr glm::vec2 viewport{1024, 768};

    std::vector<Segment> segments;
    std::vector<ClippedSegment> clipped;
    std::vector<std::uint32_t> offsets, arcs;
    std::vector<std::uint8_t> alpha;
    std::vector<std::uint32_t> runs; ///< the segment of each visible run
};

Paths make_paths(std::uint32_t n);

/// The tables of Paths on a device.
struct PathTables {
    PathTables(compute::Device& device, const Paths& paths);

    compute::SegmentTable table() const { return {*vertices, *vertices, *segments, 0, count}; }
    compute::SegmentAtlas atlas() const { return {{*clipped, *offsets, *arcs}, *alpha, samples}; }

    std::uint32_t count, samples, runs; ///< numbers of segments, samples and visible runs
    SharedBuffer vertices, segments, clipped, offsets, arcs, alpha;
};

/// A table for visible runs, and the record of a frame.
struct RunTables {
    RunTables(compute::Device& device, std::uint32_t capacity);

    /// The runs that a stage has written. Throws Error if there were more than `capacity`.
    std::vector<Run> read(compute::Device& device) const;

    std::uint32_t capacity;
    SharedBuffer runs, record;
};

/// Writes the visible runs of the paths by the stage `compact`.
void compact(compute::Stages& stages, const PathTables& paths, const RunTables& to);

} // namespace lineatlas::bench
