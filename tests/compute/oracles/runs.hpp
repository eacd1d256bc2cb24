#pragma once

// Makes runs of pieces of segments, for the oracles of `filter` and `halo`.

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "segment_table.h"
#include "shared/constants.h"

namespace lineatlas::test::oracles {

/// The tables of a frame.
struct FrameTables {
    std::span<const Segment> segments;
    std::span<const ClippedSegment> clipped;
    std::span<const std::uint32_t> offsets;
    std::span<const std::uint32_t> arcs;
    glm::vec2 viewport;
    float half_width;

    std::uint32_t samples(std::uint32_t i) const { return offsets[i + 1] - offsets[i]; }
    bool is_drawn(std::uint32_t i) const { return arcs[i + 1] != arcs[i]; }
    /// Arc length at the start of segment i and its length, pixels; zero is in the middle of its
    /// path.
    float arc(std::uint32_t i) const;
    float length(std::uint32_t i) const;
    /// True if segment i and the next one are drawn as one line: they are of the same path, and no
    /// part between them is clipped.
    bool goes_on(std::uint32_t i) const;
};

/// The kind of an end of a segment (LA_END_*), and how it meets its neighbour.
struct End {
    std::uint32_t kind;
    glm::vec2 corner{0, 0}; ///< at a join, see Run
};

/// The kind of one end of segment i: LA_END_CLIPPED, LA_END_PATH, or LA_END_JOIN if the path goes
/// on in segment `neighbour`.
std::uint32_t path_end(const FrameTables& frame, std::uint32_t i, bool at_end,
                       std::uint32_t& neighbour);

/// A position on a segment.
struct Place {
    glm::vec2 position; ///< in the window
    float depth, arc;
};

/// The place at a position in samples of segment i. l: the number of its samples, or any unit of
/// positions if it has none.
Place place_at(const FrameTables& frame, std::uint32_t i, float sample, std::uint32_t l);

/// §4.5, mitering; see shared/run.h.
End segment_end(const FrameTables& frame, std::uint32_t i, bool at_end);

/// A run between two positions in samples of segment i, which has `l` samples. The caller sets
/// address and stroke.
Run make_run(const FrameTables& frame, std::uint32_t i, float start_sample, float end_sample,
             std::uint32_t l, const End& start, const End& end);

/// True if visibility does not end at an end of run r: the path ends there, or goes on visibly.
bool shown_across(std::span<const Segment> segments, std::span<const Run> runs, std::size_t r,
                  bool at_end);

FrameRecord make_record(std::size_t runs, std::size_t capacity, std::uint32_t samples);

} // namespace lineatlas::test::oracles
