#include "interval_stage.hpp"

#include "lineatlas/error.hpp"

namespace lineatlas {

// A first guess; a frame that needs more makes the table grow.
IntervalStage::IntervalStage(compute::Backend& backend) : backend_(backend), capacity_(1U << 13U) {}

void IntervalStage::find(Frame& frame, const SegmentAtlas& input, const DepthStage& depth) {
    kept_ = wanted(frame);
    total_ = 0;
    if (!kept_) return;
    if (!total_buffer_) {
        total_buffer_ = compute::allocate(backend_, sizeof(std::uint32_t), purpose::intervals);
    }
    const std::size_t bytes = std::size_t{capacity_} * sizeof(Interval);
    if (!table_ || table_->size() < bytes) {
        table_.reset(); // it may not fit beside another
        table_ = compute::allocate(backend_, bytes, purpose::intervals);
    }
    frame.clock("intervals", [&] {
        backend_.intervals({.table = frame.scene.table(),
                            .clipped = input.clipped,
                            .alpha = input.alpha,
                            .layout = input.layout,
                            .capacity = input.capacity,
                            .viewport = frame.viewport(),
                            .depth = depth.buffer(),
                            .depth_size = depth.size(),
                            .depth_scale = static_cast<float>(frame.depth_scale()),
                            .tolerance = frame.depth_tolerance(),
                            .hidden_too = wants_hidden(frame),
                            .intervals = *table_,
                            .interval_capacity = capacity_,
                            .total = *total_buffer_});
        backend_.download(*total_buffer_, std::as_writable_bytes(std::span{&total_, 1}));
    });
}

bool IntervalStage::grow() {
    if (total_ <= capacity_) return false;
    capacity_ = capacity_for<Interval>(backend_, total_);
    return true;
}

std::vector<Interval> IntervalStage::read() {
    if (!kept_) {
        throw UsageError("renderer: read_intervals() needs a frame of method atlas with "
                         "FrameOptions::intervals");
    }
    std::vector<Interval> result(total_);
    backend_.download(*table_, std::as_writable_bytes(std::span{result}));
    // Of two at a joint only one has a length, see kernels/intervals.cl.
    std::erase_if(result, [](const Interval& interval) {
        return interval.start_sample >= interval.end_sample;
    });
    return result;
}

} // namespace lineatlas
