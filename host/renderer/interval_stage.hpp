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
    explicit IntervalStage(compute::Stages& stages);

    /// Whether the frame keeps intervals.
    static bool wanted(const Frame& frame) {
        return frame.options.intervals != KeptIntervals::none;
    }
    /// Whether hidden ones too.
    static bool wants_hidden(const Frame& frame) {
        return frame.options.intervals == KeptIntervals::all;
    }

    /// Before the first find() of a frame.
    void begin_frame();
    /// Finds the frame's intervals, if it keeps any, and waits for their number. `input`: before a
    /// style changes it.
    void find(Frame& frame, const compute::SegmentAtlas& input, const DepthStage& depth);
    /// The same of the exact method.
    void find(Frame& frame, const compute::ClippedTable& clipped, const compute::SpanTable& spans);
    /// Enlarges the table if they exceed it; true if they must be found again.
    bool grow();
    /// Where segments come in chunks: the intervals of the current one go to the host.
    void keep(const Frame& frame);
    /// Of the last frame; throws UsageError if it kept none.
    std::vector<Interval> read();

  private:
    /// Makes the tables; false if the frame keeps no intervals.
    bool prepare(const Frame& frame);
    void read_total();
    /// Of the last find().
    std::vector<Interval> read_table();

    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    std::unique_ptr<compute::Buffer> table_, total_buffer_;
    std::uint32_t capacity_;
    std::uint32_t total_ = 0;
    bool kept_ = false;
    bool in_chunks_ = false; ///< `of_chunks_` are the frame's
    std::vector<Interval> of_chunks_;
};

} // namespace lineatlas
