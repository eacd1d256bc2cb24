#pragma once

#include <vector>

#include "compute/stages/stages.hpp"
#include "table_order.hpp"

namespace lineatlas {

/// The table of intervals that a stage fills and the host reads. It grows when a frame needs more.
class IntervalTable {
  public:
    explicit IntervalTable(compute::Device& device);

    /// Call before the first room() of a frame. `kept`: whether the frame has intervals at all.
    void begin_frame(bool kept);
    bool kept() const { return kept_; }

    /// Room for as many intervals as the table has grown to.
    compute::IntervalRoom room();
    /// Waits for the number of intervals that were found in room().
    void read_total();
    /// Enlarges the table if the intervals exceed it. Returns true if they must be found again.
    bool grow();
    /// Copies the intervals of the current chunk to the host, if segments come in chunks.
    /// `first_segment`: the chunk's first segment in the whole table. `order`, `offsets`: order and
    /// sample offsets of that chunk.
    void keep(std::uint32_t first_segment, const TableOrder& order,
              std::span<const std::uint32_t> offsets);
    /// The intervals of the last frame. `order`, `offsets`: those of the last chunk.
    std::vector<Interval> read(const TableOrder& order, std::span<const std::uint32_t> offsets);

    /// The intervals of the current chunk alone, after the last read_total().
    std::vector<Interval> read_table();

  private:
    compute::Device& device_;
    compute::Table table_{device_, compute::table::intervals},
        total_buffer_{device_, compute::table::interval_total};
    std::uint32_t capacity_;
    std::uint32_t total_ = 0;
    bool kept_ = false;
    bool in_chunks_ = false; ///< the frame's intervals are in `of_chunks_`
    std::vector<Interval> of_chunks_;
};

} // namespace lineatlas
