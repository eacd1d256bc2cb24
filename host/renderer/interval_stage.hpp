#pragma once

#include <vector>

#include "depth_stage.hpp"
#include "frame.hpp"
#include "visibility/interval_table.hpp"

namespace lineatlas {

/// From the segment atlas to what comes out of the device: intervals of lines (§4.6).
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
    void begin_frame(const Frame& frame) { table_.begin_frame(wanted(frame)); }
    /// Finds the frame's intervals, if it keeps any, and waits for their number. `input`: before a
    /// style changes it.
    void find(Frame& frame, const compute::SegmentAtlas& input, const DepthStage& depth);
    /// The same of the exact method.
    void find(Frame& frame, const compute::ClippedTable& clipped, const compute::SpanTable& spans);
    /// Enlarges the table if they exceed it; true if they must be found again.
    bool grow() { return table_.grow(); }
    /// Where segments come in chunks: the intervals of the current one go to the host.
    void keep(const Frame& frame) { table_.keep(frame.scene.first_segment()); }
    /// Of the last frame; throws UsageError if it kept none.
    std::vector<Interval> read();

  private:
    compute::Stages& stages_;
    IntervalTable table_;
};

} // namespace lineatlas
