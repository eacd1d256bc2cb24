#pragma once

#include <vector>

#include "core/progress.hpp"
#include "exact_lines.hpp"
#include "interval_table.hpp"

namespace lineatlas {

/// A line set on a device, at its present places.
struct PlacedLines {
    const LineTables& tables;
    compute::Buffer& vertices; ///< in place of those of `tables`
    std::uint32_t vertex_count, triangle_count;
    compute::Buffer* corners = nullptr; ///< in place of those of contours; null: they stand there

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
    /// With tables for such lines, which may move.
    ExactIntervals(compute::Stages& stages, const PlacedLines& lines);

    /// The lines are others, in the same tables.
    void forget_lines() { lines_.forget_lines(); }

    /// What find() looks for.
    struct Wanted {
        bool hidden = false;                          ///< hidden pieces too
        std::vector<OutlinePart>* outlines = nullptr; ///< to be filled
        float outline_depth = 0;                      ///< see VisibilityOptions
    };
    /// In order of the segments; see LineVisibility::find(). If it throws, this is of no more use.
    std::vector<Interval> find(const PlacedLines& lines, const LineView& view, const Wanted& wanted,
                               const ProgressPart& progress);

  private:
    void find_chunk(const LineView& view, const compute::SegmentTable& segments,
                    const compute::SpanTable& spans, bool hidden);

    compute::Stages& stages_;
    ExactLines lines_;
    IntervalTable intervals_;
};

} // namespace lineatlas
