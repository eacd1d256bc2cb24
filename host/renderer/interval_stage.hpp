#pragma once

#include <memory>
#include <vector>

#include "depth_stage.hpp"
#include "frame.hpp"

namespace lineatlas {

/// From the segment atlas to what comes out of the device: intervals of lines (§4.6). Its table
/// grows when a frame needs more.
class IntervalStage {
  public:
    explicit IntervalStage(compute::Backend& backend);

    /// Whether the frame keeps intervals.
    static bool wanted(const Frame& frame) {
        return frame.options.intervals != KeptIntervals::none;
    }
    /// Whether hidden ones too.
    static bool wants_hidden(const Frame& frame) {
        return frame.options.intervals == KeptIntervals::all;
    }

    /// Finds the frame's intervals, if it keeps any, and waits for their number. `input`: before a
    /// style changes it.
    void find(Frame& frame, const SegmentAtlas& input, const DepthStage& depth);
    /// Enlarges the table if they exceed it; true if they must be found again.
    bool grow();
    /// Of the last frame; throws UsageError if it kept none.
    std::vector<Interval> read();

  private:
    compute::Backend& backend_;
    std::unique_ptr<compute::Buffer> table_, total_buffer_;
    std::uint32_t capacity_;
    std::uint32_t total_ = 0;
    bool kept_ = false;
};

} // namespace lineatlas
