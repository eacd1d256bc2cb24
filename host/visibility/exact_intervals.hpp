#pragma once

#include <vector>

#include "core/progress.hpp"
#include "exact_lines.hpp"
#include "interval_table.hpp"

namespace lineatlas {

/// A line set on a device, at its current places.
struct PlacedLines {
    const LineTables& tables;
    compute::Buffer& vertices; ///< the current vertices, in place of those of `tables`
    std::uint32_t vertex_count, triangle_count;
    compute::Buffer* corners = nullptr; ///< in place of the corners of contours in `tables`; null:
                                        ///< those are current

    compute::SegmentTable chunk(std::size_t i) const {
        const LineTables::Chunk& part = tables.chunks[i];
        return {.vertices = vertices,
                .triangles = *tables.triangles,
                .segments = *part.segments,
                .triangle_count = triangle_count,
                .segment_count = part.range.count,
                .candidates = part.candidates(corners),
                .version = tables.version};
    }
};

/// The exact method as intervals on the host, without a picture.
class ExactIntervals {
  public:
    /// Makes tables for lines of this size. The lines may move.
    ExactIntervals(compute::Stages& stages, const PlacedLines& lines);

    /// Call when the tables hold other lines.
    void forget_lines() { lines_.forget_lines(); }

    /// What find() looks for.
    struct Wanted {
        bool hidden = false;                          ///< hidden pieces too
        std::vector<OutlinePart>* outlines = nullptr; ///< to be filled
        float outline_depth = 0;                      ///< see VisibilityOptions
    };
    /// The intervals in the order of the segments, see LineVisibility::find(). If it throws, the
    /// object cannot be used any more.
    std::vector<Interval> find(const PlacedLines& lines, const LineView& view, const Wanted& wanted,
                               const ProgressPart& progress);

  private:
    compute::Stages& stages_;
    ExactLines lines_;
    IntervalTable intervals_;
};

} // namespace lineatlas
