#include "carried_coordinates.hpp"

namespace lineatlas::compute {

void CarriedCoordinates::release() {
    tables_.release();
    count_ = 0;
}

void CarriedCoordinates::find(const SegmentTable& table, std::uint32_t first,
                              const ClippedTable& clipped, glm::vec2 viewport, float limit) {
    first_ = first;
    count_ = table.segment_count - first;
    arcs_ = &clipped.arcs;
    if (count_ == 0) return forget();
    constexpr std::uint64_t word = sizeof(la_uint);
    const std::uint64_t n = count_, remembered = word * LA_MEMORY_WORDS * table.candidates.count;
    if (tables_.make_room(Table::memory, remembered))
        device_.clear(tables_[Table::memory], remembered);
    for (const Table each : {Table::lengths, Table::found, Table::kept, Table::breaks, Table::means,
                             Table::pieces, Table::list, Table::shifts}) {
        tables_.make_room(each, (n + 1) * word);
    }
    tables_.make_room(Table::recalled, 2 * n * word);
    tables_.make_room(Table::carried, 2 * n * word);
    stages_.carry({.table = table,
                   .first = first,
                   .count = count_,
                   .clipped = clipped,
                   .viewport = viewport,
                   .frame = frame_++,
                   .limit = limit,
                   .memory = tables_[Table::memory],
                   .lengths = tables_[Table::lengths],
                   .found = tables_[Table::found],
                   .kept = tables_[Table::kept],
                   .breaks = tables_[Table::breaks],
                   .means = tables_[Table::means],
                   .recalled = tables_[Table::recalled],
                   .list = tables_[Table::list],
                   .pieces = tables_[Table::pieces],
                   .shifts = tables_[Table::shifts],
                   .carried = tables_[Table::carried]});
}

void CarriedCoordinates::apply(Buffer& runs, Buffer& record, std::uint32_t run_capacity) {
    if (count_ == 0) return;
    stages_.launch<kernels::carry_runs>(
        run_capacity,
        {.count = run_capacity, .first = first_, .viewport = {}, .frame = 0, .limit = 0},
        {.arcs = *arcs_, .carried = tables_[Table::carried], .record = record, .runs = runs});
}

} // namespace lineatlas::compute
