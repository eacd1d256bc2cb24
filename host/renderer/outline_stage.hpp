#pragma once

#include <cstdint>

#include "depth_stage.hpp"
#include "frame.hpp"

namespace lineatlas {

/// `outline` of the segment atlas: which parts of segments have the background beside them in the
/// depth buffer. The exact method finds its own (ExactLines::outline()).
class OutlineStage {
  public:
    explicit OutlineStage(compute::Stages& stages)
        : stages_(stages), offsets_(stages.device(), compute::table::outline_offsets),
          parts_(stages.device(), compute::table::outline_parts) {}

    /// Of the frame's segments; waits for their number. `atlas`: its samples are not read.
    compute::OutlineTable find(Frame& frame, const compute::SegmentAtlas& atlas, DepthStage& depth);
    /// What find() found.
    compute::OutlineTable found() const { return {*offsets_, *parts_}; }

  private:
    compute::Stages& stages_;
    compute::Table offsets_, parts_;
    std::uint32_t capacity_ = 0; ///< of `parts_`
};

} // namespace lineatlas
