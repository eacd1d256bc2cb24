#include "carried_coordinates.hpp"

#include <cmath>

namespace lineatlas::compute {

void CarryTables::make_room(std::uint32_t candidates, std::uint32_t silhouettes) {
    constexpr std::uint64_t word = sizeof(la_uint);
    const std::uint64_t n = silhouettes, remembered = word * LA_MEMORY_WORDS * candidates;
    if (memory.make_room(remembered)) device->clear(*memory, remembered);
    for (Table* each : {&lengths, &found, &kept, &breaks, &means, &pieces, &list, &shifts})
        each->make_room((n + 1) * word);
    for (Table* each : {&recalled, &carried}) each->make_room(2 * n * word);
}

void Stages::carry(const CarryArgs& args) {
    const std::uint32_t n = args.count;
    const CarryTables& tables = args.tables;
    const CarryParameters parameters{
        .count = n,
        .first = args.first,
        .viewport = args.viewport,
        .frame = args.frame,
        .limit = static_cast<la_uint>(std::floor(args.limit * LA_ARC_UNITS_PER_PIXEL))};
    launch<kernels::carry_recall>(n, parameters, args.table, args.clipped, tables);
    scan(*tables.lengths, n, ScanKind::wrap);
    launch<kernels::carry_keep>(n, parameters, args.table, tables);
    scan(*tables.kept, n, ScanKind::saturate);
    launch_each<kernels::scan_list>(n, {.values = *tables.kept, .list = *tables.list});
    launch<kernels::carry_breaks>(n, parameters, args.table, tables);
    scan(*tables.breaks, n, ScanKind::saturate);
    scan(*tables.means, n, ScanKind::wrap);
    launch<kernels::carry_pieces>(n, parameters, tables);
    launch<kernels::carry_settle>(n, parameters, tables);
    launch<kernels::carry_place>(n, parameters, args.table, args.clipped, tables);
}

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
