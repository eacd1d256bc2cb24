#pragma once

// Arguments of the stages of the exact method.

#include <cstdint>

#include <glm/vec2.hpp>

#include "tables.hpp"

namespace lineatlas::compute {

/// The visible parts of all segments, as `visible` leaves them.
struct SpanTable {
    Buffer& span_offsets;
    Buffer& spans;
    std::uint32_t capacity; ///< spans that there is room for
};

/// Arguments for finding outlines from the visible parts of ways beside segments.
struct OutlinePartsArgs {
    std::uint32_t segment_count;
    Buffer& numbers;          ///< of outline_seen()
    Buffer& arcs;             ///< of ClippedTable
    float depth;              ///< pixels that a body must be deep
    SpanTable beside, within; ///< of the ways of outline_push() and outline_push_in()
    Buffer& part_offsets;     ///< out: segment_count + 1 uint32
    Buffer& parts;            ///< out: 2 floats each; none if `part_capacity` is too small
    std::uint32_t part_capacity;
};

/// Runs of spans, as CompactArgs of samples.
struct SpanRunsArgs {
    SegmentTable table;
    ClippedTable clipped; ///< `offsets`: all 0
    SpanTable spans;
    glm::vec2 viewport; ///< pixels
    float half_width;   ///< as in CompactArgs
    bool hidden;        ///< runs of hidden parts instead
    RunTable runs;      ///< out
};

/// Intervals of spans, as IntervalsArgs of samples.
struct SpanIntervalsArgs {
    SegmentTable table;
    ClippedTable clipped; ///< `offsets`: all 0
    SpanTable spans;
    glm::vec2 viewport; ///< pixels
    bool hidden_too;    ///< hidden pieces too
    IntervalRoom into;  ///< out
};

} // namespace lineatlas::compute
