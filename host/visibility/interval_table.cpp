#include "interval_table.hpp"

namespace lineatlas {

// A first guess; a frame that needs more makes the table grow.
IntervalTable::IntervalTable(compute::Device& device)
    : device_(device), capacity_(compute::first_capacity<Interval>(device_, 1U << 13U)) {}

void IntervalTable::begin_frame(bool kept) {
    kept_ = kept;
    total_ = 0;
    in_chunks_ = false;
    of_chunks_.clear();
}

compute::IntervalRoom IntervalTable::room() {
    total_buffer_.fit(sizeof(std::uint32_t));
    table_.fit(std::uint64_t{capacity_} * sizeof(Interval));
    return {*table_, capacity_, *total_buffer_};
}

void IntervalTable::read_total() {
    device_.download(*total_buffer_, std::as_writable_bytes(std::span{&total_, 1}));
}

bool IntervalTable::grow() {
    if (total_ <= capacity_) return false;
    capacity_ = compute::capacity_for<Interval>(device_, total_);
    return true;
}

void IntervalTable::keep(std::uint32_t first_segment, const TableOrder& order,
                         std::span<const std::uint32_t> offsets) {
    in_chunks_ = true;
    if (!kept_) return;
    std::vector<Interval> found = read_table();
    order.restore(found, offsets);
    for (Interval& interval : found) {
        interval.segment += first_segment;
        of_chunks_.push_back(interval);
    }
}

std::vector<Interval> IntervalTable::read(const TableOrder& order,
                                          std::span<const std::uint32_t> offsets) {
    if (in_chunks_) return of_chunks_;
    std::vector<Interval> found = read_table();
    order.restore(found, offsets);
    return found;
}

std::vector<Interval> IntervalTable::read_table() {
    std::vector<Interval> result(total_);
    if (total_ > 0) device_.download(*table_, std::as_writable_bytes(std::span{result}));
    // Of two intervals at a joint only one has a length, see kernels/intervals.cl.
    std::erase_if(result, [](const Interval& interval) {
        return interval.start_sample >= interval.end_sample;
    });
    return result;
}

} // namespace lineatlas
