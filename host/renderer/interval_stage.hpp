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
    /// Whether hidden ones too.
    static bool wants_hidden(const Frame& frame) {
        return frame.options.intervals == KeptIntervals::all;
    }

    /// Before the first find() of a frame.
    void begin_frame(const Frame& frame) {
        table_.begin_frame(wanted(frame));
        outlines_.clear();
    }
    /// Whether add_outlines() is to come after find().
    static bool wants_outlines(const Frame& frame) {
        return wanted(frame) && tells_outlines(frame.options.style);
    }
    /// Finds the frame's intervals, if it keeps any, and waits for their number. `input`: before a
    /// style changes it.
    void find(Frame& frame, const compute::SegmentAtlas& input, DepthStage& depth);
    /// The same of the exact method.
    void find(Frame& frame, const compute::ClippedTable& clipped, const compute::SpanTable& spans);
    /// What of the current chunk's intervals, whose segments stand in that order, is outline.
    void add_outlines(const Frame& frame, const compute::OutlineTable& table,
                      const TableOrder& order);
    /// Enlarges the table if they exceed it; true if they must be found again.
    bool grow() { return table_.grow(); }
    /// Where segments come in chunks: the intervals of the current one go to the host.
    void keep(const Frame& frame, const TableOrder& order, std::span<const std::uint32_t> offsets) {
        table_.keep(frame.scene.first_segment(), order, offsets);
    }
    /// Of the last frame; throws UsageError if it kept none.
    std::vector<Interval> read(const TableOrder& order, std::span<const std::uint32_t> offsets);
    /// Likewise; empty where wants_outlines() was not so.
    std::vector<OutlinePart> read_outlines() const { return outlines_; }

  private:
    compute::Stages& stages_;
    IntervalTable table_;
    std::vector<OutlinePart> outlines_; ///< of the frame
};

} // namespace lineatlas
