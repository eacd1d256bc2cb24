#include "batches.hpp"

#include <utility>

namespace lineatlas::compute {

void Batches::release() {
    boxes_.release();
    states_.release();
    forget();
}

Batches::Step Batches::next(const Of& of) {
    if (of.count == 0) return Step::wait;
    if (of != of_) {
        of_ = of;
        made_ = false;
        const std::uint64_t batches = divide_up(of.count, LA_BATCH);
        boxes_.fit(batches * sizeof(Batch));
        states_.fit(batches);
        return Step::wait;
    }
    count_ = of.count;
    return std::exchange(made_, true) ? Step::keep : Step::make;
}

template <class Boxes>
bool Batches::has(const SegmentTable& table, const Buffer& elements, std::uint32_t count) {
    const Step step = next({.elements = &elements,
                            .vertices = &table.vertices,
                            .version = table.version,
                            .count = count});
    const BatchTable made = this->table();
    if (step == Step::make) stages_.launch<Boxes>(made.batch_count(), {count_}, table, made);
    return step != Step::wait;
}

bool Batches::has_segments(const SegmentTable& table) {
    return has<kernels::project_clip_boxes>(table, table.segments,
                                            table.segment_count - table.candidates.count);
}

bool Batches::has_triangles(const SegmentTable& table) {
    return has<kernels::surfaces_boxes>(table, table.triangles, table.triangle_count);
}

} // namespace lineatlas::compute
