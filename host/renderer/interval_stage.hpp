#pragma once

#include <vector>

#include "depth_stage.hpp"
#include "frame.hpp"
#include "visibility/interval_table.hpp"

namespace lineatlas {

/// From the segment atlas to intervals of lines, which are read back (§4.6).
class IntervalStage {
  public:
    explicit IntervalStage(compute::Stages& stages) : stages_(stages), table_(stages.device()) {}

    /// Whether the frame keeps intervals.
    static bool wanted(const Frame& frame) {
        return frame.options.intervals != KeptIntervals::none;
    }
    /// Whether the frame keeps hidden intervals too.
    static bool wants_hidden(const Frame& frame) {
        return frame.options.intervals == KeptIntervals::all;
    }

    /// Call before the first find() of a frame.
    void begin_frame(const Frame& frame) {
        table_.begin_frame(wanted(frame));
        outlines_.clear();
    }
    /// Whether add_outlines() must follow find().
    static bool wants_outlines(const Frame& frame) {
        return wanted(frame) && tells_outlines(frame.options.style);
    }
    /// Finds the frame's intervals, if it keeps any, and waits for their number. `input`: the atlas
    /// before a style changes it.
    void find(Frame& frame, const compute::SegmentAtlas& input, DepthStage& depth);
    /// As above, for the exact method.
    void find(Frame& frame, const compute::ClippedTable& clipped, const compute::SpanTable& spans);
    /// Reads which parts of the current chunk's intervals are outline. order: that of the chunk's
    /// segments.
    void add_outlines(const Frame& frame, const compute::OutlineTable& table,
                      const TableOrder& order);
    /// Enlarges the table if the intervals exceed it. Returns true if they must be found again.
    bool grow() { return table_.grow(); }
    /// Copies the intervals of the current chunk to the host, if segments come in chunks.
    void keep(const Frame& frame, const TableOrder& order, std::span<const std::uint32_t> offsets) {
        table_.keep(frame.scene.first_segment(), order, offsets);
    }
    /// The intervals of the last frame. Throws UsageError if it kept none.
    std::vector<Interval> read(const TableOrder& order, std::span<const std::uint32_t> offsets);
    /// The outlines of the last frame; empty if wants_outlines() was false.
    std::vector<OutlinePart> read_outlines() const { return outlines_; }

  private:
    compute::Stages& stages_;
    IntervalTable table_;
    std::vector<OutlinePart> outlines_; ///< of the frame
};

} // namespace lineatlas
