#include "batches.hpp"

#include <utility>

#include "divide_up.hpp"

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

bool Batches::has_segments(const SegmentTable& table) {
    const Step step = next({.elements = &table.segments,
                            .vertices = &table.vertices,
                            .version = table.version,
                            .count = table.segment_count - table.candidates.count});
    if (step == Step::make) {
        const BatchTable made = this->table();
        stages_.launch<kernels::project_clip_boxes>(made.batch_count(), {count_}, table, made);
    }
    return step != Step::wait;
}

bool Batches::has_triangles(const SegmentTable& table) {
    const Step step = next({.elements = &table.triangles,
                            .vertices = &table.vertices,
                            .version = table.version,
                            .count = table.triangle_count});
    if (step == Step::make) {
        const BatchTable made = this->table();
        stages_.launch<kernels::surfaces_boxes>(made.batch_count(), {count_}, table, made);
    }
    return step != Step::wait;
}

} // namespace lineatlas::compute
