#pragma once

#include <cstdint>

#include "depth_stage.hpp"
#include "frame.hpp"

namespace lineatlas {

/// `outline` for the segment atlas: finds which parts of segments have the background beside them
/// in the depth buffer. The exact method has ExactLines::outline().
class OutlineStage {
  public:
    explicit OutlineStage(compute::Stages& stages)
        : stages_(stages), offsets_(stages.device(), compute::table::outline_offsets),
          parts_(stages.device(), compute::table::outline_parts) {}

    /// Finds the outlines among the frame's segments, and waits for their number. `atlas`: its
    /// samples are not read.
    compute::OutlineTable find(Frame& frame, const compute::SegmentAtlas& atlas, DepthStage& depth);
    /// The result of the last find().
    compute::OutlineTable found() const { return {*offsets_, *parts_}; }

  private:
    compute::Stages& stages_;
    compute::Table offsets_, parts_;
    std::uint32_t capacity_ = 0; ///< of `parts_`
};

} // namespace lineatlas
