#include "interval_stage.hpp"

#include "lineatlas/error.hpp"

namespace lineatlas {

// A first guess; a frame that needs more makes the table grow.
IntervalStage::IntervalStage(compute::Stages& stages)
    : stages_(stages), device_(stages.device()),
      capacity_(compute::first_capacity<Interval>(device_, 1U << 13U)) {}

void IntervalStage::begin_frame() {
    in_chunks_ = false;
    of_chunks_.clear();
}

void IntervalStage::keep(const Frame& frame) {
    in_chunks_ = true;
    if (!kept_) return;
    for (Interval& interval : read_table()) {
        interval.segment += frame.scene.first_segment();
        of_chunks_.push_back(interval);
    }
}

bool IntervalStage::prepare(const Frame& frame) {
    kept_ = wanted(frame);
    total_ = 0;
    if (!kept_) return false;
    if (!total_buffer_) {
        total_buffer_ = compute::allocate(device_, sizeof(std::uint32_t), purpose::intervals);
    }
    const std::size_t bytes = std::size_t{capacity_} * sizeof(Interval);
    if (!table_ || table_->size() < bytes) {
        table_.reset(); // it may not fit beside another
        table_ = compute::allocate(device_, bytes, purpose::intervals);
    }
    return true;
}

void IntervalStage::read_total() {
    device_.download(*total_buffer_, std::as_writable_bytes(std::span{&total_, 1}));
}

void IntervalStage::find(Frame& frame, const compute::SegmentAtlas& input,
                         const DepthStage& depth) {
    if (!prepare(frame)) return;
    frame.clock("intervals", [&] {
        stages_.intervals({.table = frame.scene.table(),
                           .atlas = input,
                           .viewport = frame.viewport(),
                           .depth = frame.depth_buffer(depth.buffer(), depth.size()),
                           .hidden_too = wants_hidden(frame),
                           .intervals = *table_,
                           .interval_capacity = capacity_,
                           .total = *total_buffer_});
        read_total();
    });
}

void IntervalStage::find(Frame& frame, const compute::ClippedTable& clipped,
                         const compute::SpanTable& spans) {
    if (!prepare(frame)) return;
    frame.clock("intervals", [&] {
        stages_.span_intervals({.table = frame.scene.table(),
                                .clipped = clipped,
                                .spans = spans,
                                .viewport = frame.viewport(),
                                .hidden_too = wants_hidden(frame),
                                .intervals = *table_,
                                .interval_capacity = capacity_,
                                .total = *total_buffer_});
        read_total();
    });
}

bool IntervalStage::grow() {
    if (total_ <= capacity_) return false;
    capacity_ = capacity_for<Interval>(device_, total_);
    return true;
}

std::vector<Interval> IntervalStage::read() {
    if (!kept_) {
        throw UsageError("renderer: read_intervals() needs a frame of method atlas or exact with "
                         "FrameOptions::intervals");
    }
    return in_chunks_ ? of_chunks_ : read_table();
}

std::vector<Interval> IntervalStage::read_table() {
    std::vector<Interval> result(total_);
    device_.download(*table_, std::as_writable_bytes(std::span{result}));
    // Of two at a joint only one has a length, see kernels/intervals.cl.
    std::erase_if(result, [](const Interval& interval) {
        return interval.start_sample >= interval.end_sample;
    });
    return result;
}

} // namespace lineatlas
