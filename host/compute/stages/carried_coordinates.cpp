#include "carried_coordinates.hpp"

namespace lineatlas::compute {

void CarriedCoordinates::release() {
    tables_ = {tables_.device};
    count_ = 0;
}

void CarriedCoordinates::find(const SegmentTable& table, std::uint32_t first,
                              const ClippedTable& clipped, glm::vec2 viewport, float limit) {
    first_ = first;
    count_ = table.segment_count - first;
    arcs_ = &clipped.arcs;
    if (count_ == 0) return forget();
    tables_.make_room(table.candidates.count, count_);
    stages_.carry({.table = table,
                   .first = first,
                   .count = count_,
                   .clipped = clipped,
                   .viewport = viewport,
                   .frame = frame_++,
                   .limit = limit,
                   .tables = tables_});
}

void CarriedCoordinates::apply(const RunTable& runs) {
    if (count_ == 0) return;
    stages_.launch<kernels::carry_runs>(
        runs.capacity,
        {.count = runs.capacity, .first = first_, .viewport = {}, .frame = 0, .limit = 0},
        {.arcs = arcs_}, tables_, runs);
}

} // namespace lineatlas::compute
