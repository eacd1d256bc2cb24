#include "interval_stage.hpp"

#include "lineatlas/error.hpp"
#include "visibility/outline_parts.hpp"

namespace lineatlas {

void IntervalStage::find(Frame& frame, const compute::SegmentAtlas& input, DepthStage& depth) {
    if (!table_.kept()) return;
    frame.clock("intervals", [&] {
        stages_.intervals({.table = frame.scene.table(),
                           .atlas = input,
                           .viewport = frame.viewport(),
                           .depth = depth.probed(frame),
                           .hidden_too = wants_hidden(frame),
                           .into = table_.room()});
        table_.read_total();
    });
}

void IntervalStage::find(Frame& frame, const compute::ClippedTable& clipped,
                         const compute::SpanTable& spans) {
    if (!table_.kept()) return;
    frame.clock("intervals", [&] {
        stages_.span_intervals({.table = frame.scene.table(),
                                .clipped = clipped,
                                .spans = spans,
                                .viewport = frame.viewport(),
                                .hidden_too = wants_hidden(frame),
                                .into = table_.room()});
        table_.read_total();
    });
}

void IntervalStage::add_outlines(const Frame& frame, const compute::OutlineTable& table,
                                 const TableOrder& order) {
    add_outline_parts(stages_.device(), table, table_.read_table(), order,
                      frame.scene.first_segment(), frame.scene.table().segment_count, outlines_);
}

std::vector<Interval> IntervalStage::read(const TableOrder& order,
                                          std::span<const std::uint32_t> offsets) {
    if (!table_.kept()) {
        throw UsageError("renderer: read_intervals() needs a frame of method atlas or exact with "
                         "FrameOptions::intervals");
    }
    return table_.read(order, offsets);
}

} // namespace lineatlas
