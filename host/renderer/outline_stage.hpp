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
        : stages_(stages), tables_(stages.device(), purpose::segments) {}

    /// Of the frame's segments; waits for their number. `atlas`: its samples are not read.
    compute::OutlineTable find(Frame& frame, const compute::SegmentAtlas& atlas, DepthStage& depth);
    /// What find() found.
    compute::OutlineTable found() const { return {tables_[Table::offsets], tables_[Table::parts]}; }

  private:
    enum class Table { offsets, parts, count };

    compute::Stages& stages_;
    compute::GrowingTables<Table> tables_;
    std::uint32_t capacity_ = 0; ///< of Table::parts
};

} // namespace lineatlas
