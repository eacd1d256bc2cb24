#pragma once

// Arguments of the stages of the exact method.

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "tables.hpp"

namespace lineatlas::compute {

/// The tables of the exact method. kernels/exact_tables.h says what each holds.
struct ExactArgs {
    SegmentTable table;
    ClippedTable clipped;       ///< `offsets` is not read
    ExactParameters parameters; ///< without those of chunks and `batched`
    Buffer& screen;             ///< 4 floats per vertex
    Buffer& faces;              ///< `ScreenFace` per triangle
    Buffer& planes;             ///< 4 floats per triangle
    Buffer& occluders;          ///< a uint32 per tile
    Buffer& ends;               ///< list_columns() uint32 per tile, and the number of entries
    Buffer& groups;             ///< a uint32 per tile, and the number of groups
    Buffer& entries;            ///< `Entry` each, entry_capacity of them
    Buffer& blocks;             ///< LA_GROUP_FLOATS floats per group, group_capacity of them
    Buffer& boxes;              ///< LA_BOX_FLOATS floats for group_capacity + LA_GROUP groups
    Buffer& kept;               ///< 4 floats per segment
    Buffer& span_offsets;       ///< out: a uint32 per segment, and the number of spans
    Buffer& spans;              ///< out: 2 floats per span; none if span_capacity is too small
    /// Batches of all triangles; surfaces() finds which cannot be seen. Null: each triangle is
    /// looked at alone.
    const BatchTable* batches = nullptr;
    /// For ways beside segments (ExactParameters::beside): OutlineArgs::seen.
    Buffer* seen = nullptr;
};

/// The number of ends that a tile's list has while it is filled.
inline std::uint32_t list_columns(const Tuning& tuning) {
    return tuning.face_lists ? 1 : tuning.face_chunks;
}

/// The visible parts of all segments, as `visible` leaves them.
struct SpanTable {
    Buffer& span_offsets;
    Buffer& spans;
    std::uint32_t capacity; ///< spans that there is room for
};

/// Arguments for finding segments that are seen and may be outline.
struct OutlineSeenArgs {
    SegmentTable table;
    ClippedTable clipped;
    SpanTable spans; ///< visible parts of the segments
    Buffer& numbers; ///< out: segment_count + 1 uint32: how many such segments there are before
                     ///< each, and in all
};

/// Arguments for finding outlines from the visible parts of ways beside segments.
struct OutlinePartsArgs {
    std::uint32_t segment_count;
    Buffer& numbers;          ///< of OutlineSeenArgs
    Buffer& arcs;             ///< of ClippedTable
    float depth;              ///< as in OutlineArgs
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
    Buffer& runs;       ///< out: `Run` each
    std::uint32_t run_capacity;
    Buffer& record; ///< out: one `FrameRecord`
};

/// Intervals of spans, as IntervalsArgs of samples.
struct SpanIntervalsArgs {
    SegmentTable table;
    ClippedTable clipped; ///< `offsets`: all 0
    SpanTable spans;
    glm::vec2 viewport; ///< pixels
    bool hidden_too;    ///< hidden pieces too
    Buffer& intervals;  ///< out: `Interval` each; none if there are more than it has room for
    std::uint32_t interval_capacity;
    Buffer& interval_total; ///< out: one uint32, how many there are
};

} // namespace lineatlas::compute
