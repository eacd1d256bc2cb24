#pragma once

#include <memory>
#include <vector>

#include "compute/stages/stages.hpp"
#include "table_order.hpp"

namespace lineatlas {

/// The table of intervals that a stage fills and the host reads. It grows when a frame needs more.
class IntervalTable {
  public:
    explicit IntervalTable(compute::Device& device);

    /// Before the first room() of a frame. `kept`: whether the frame has intervals at all.
    void begin_frame(bool kept);
    bool kept() const { return kept_; }
    /// Where a stage writes to.
    struct Room {
        compute::Buffer& intervals;
        std::uint32_t capacity;
        compute::Buffer& total;
    };
    /// Room for as many as it has grown to.
    Room room();
    /// Waits for the number of intervals that were found in room().
    void read_total();
    /// Enlarges the table if they exceed it; true if they must be found again.
    bool grow();
    /// Where segments come in chunks: the intervals of the current one, whose first segment that is
    /// in the whole table, go to the host. `order`: of that chunk, whose samples begin at
    /// `offsets`.
    void keep(std::uint32_t first_segment, const TableOrder& order,
              std::span<const std::uint32_t> offsets);
    /// Of the last frame; `order` and `offsets`: of the last chunk.
    std::vector<Interval> read(const TableOrder& order, std::span<const std::uint32_t> offsets);

    /// Of the current chunk alone, after the last read_total().
    std::vector<Interval> read_table();

  private:
    compute::Device& device_;
    compute::Table table_{device_, compute::table::intervals},
        total_buffer_{device_, compute::table::interval_total};
    std::uint32_t capacity_;
    std::uint32_t total_ = 0;
    bool kept_ = false;
    bool in_chunks_ = false; ///< `of_chunks_` are the frame's
    std::vector<Interval> of_chunks_;
};

} // namespace lineatlas
