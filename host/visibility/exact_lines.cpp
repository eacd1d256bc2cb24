#include "exact_lines.hpp"

namespace lineatlas {

void ExactLines::release() {
    chains_.release();
    batches_.release();
    visibility_.release();
    clipped_.release();
    arcs_.release();
    no_offsets_.release();
}

void ExactLines::make_tables(std::uint32_t fixed_segments) {
    release();
    silhouettes_grew_ = false;
    make_room(fixed_segments);
}

void ExactLines::make_room(std::uint32_t segments) {
    std::size_t sums = (std::size_t{segments} + 1) * sizeof(la_uint);
    if (arcs_.bytes() >= sums) return;
    if (arcs_) { // tables of the first frame fit it; later frames have other silhouettes
        if (silhouettes_grew_) segments = compute::capacity_for<ClippedSegment>(device_, segments);
        silhouettes_grew_ = true;
        sums = (std::size_t{segments} + 1) * sizeof(la_uint);
    }
    for (compute::Table* table : {&clipped_, &arcs_, &no_offsets_})
        table->release(); // others may not fit beside these
    clipped_.fit(segments * sizeof(ClippedSegment));
    arcs_.fit(sums);
    no_offsets_.fit(sums);
    device_.clear(*no_offsets_, sums);
}

void ExactLines::project_clip(const LineView& view, const compute::SegmentTable& candidates,
                              const compute::SegmentTable& table) {
    compute::BatchTable batches;
    if (batches_.has_segments(candidates)) {
        batches = batches_.table();
        visibility_.find_batches(batches, !view.measured);
    }
    stages_.project_clip({.table = table,
                          .front = chains_.front(),
                          .clip_from_world = view.camera.clip_from_world(),
                          .viewport = view.viewport(),
                          .step = view.step,
                          .kind_mask = view.lines,
                          .occlusion = nullptr,
                          .out = {*clipped_, visibility_.counts(), *arcs_},
                          .batches = batches,
                          .centre_overhang = view.centre_overhang});
}

} // namespace lineatlas
