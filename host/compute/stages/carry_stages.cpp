// Texture coordinates of silhouettes, from frame to frame.
#include <cmath>

#include "stages.hpp"

namespace lineatlas::compute {

void Stages::carry(const CarryArgs& args) {
    const std::uint32_t n = args.count;
    const CarryParameters parameters{
        .count = n,
        .first = args.first,
        .viewport = args.viewport,
        .frame = args.frame,
        .limit = static_cast<la_uint>(std::floor(args.limit * LA_ARC_UNITS_PER_PIXEL))};
    const ClippedTable& clipped = args.clipped;
    launch<kernels::carry_recall>(n, tuning_.local_size, parameters,
                                  {.segments = args.table.segments,
                                   .clipped = clipped.clipped,
                                   .arcs = clipped.arcs,
                                   .origins = *args.table.origins,
                                   .memory = args.memory,
                                   .lengths = args.lengths,
                                   .found = args.found,
                                   .recalled = args.recalled});
    scan(args.lengths, n, ScanKind::wrap);
    launch<kernels::carry_keep>(n, tuning_.local_size, parameters,
                                {.segments = args.table.segments,
                                 .lengths = args.lengths,
                                 .found = args.found,
                                 .recalled = args.recalled,
                                 .kept = args.kept});
    scan(args.kept, n, ScanKind::saturate);
    list(args.kept, n, args.list);
    launch<kernels::carry_breaks>(n, tuning_.local_size, parameters,
                                  {.segments = args.table.segments,
                                   .lengths = args.lengths,
                                   .recalled = args.recalled,
                                   .kept = args.kept,
                                   .list = args.list,
                                   .breaks = args.breaks,
                                   .means = args.means});
    scan(args.breaks, n, ScanKind::saturate);
    scan(args.means, n, ScanKind::wrap);
    launch<kernels::carry_pieces>(
        n, tuning_.local_size, parameters,
        {.kept = args.kept, .breaks = args.breaks, .pieces = args.pieces});
    launch<kernels::carry_settle>(n, tuning_.local_size, parameters,
                                  {.kept = args.kept,
                                   .breaks = args.breaks,
                                   .means = args.means,
                                   .pieces = args.pieces,
                                   .shifts = args.shifts});
    launch<kernels::carry_place>(n, tuning_.local_size, parameters,
                                 {.segments = args.table.segments,
                                  .clipped = clipped.clipped,
                                  .arcs = clipped.arcs,
                                  .origins = *args.table.origins,
                                  .lengths = args.lengths,
                                  .recalled = args.recalled,
                                  .kept = args.kept,
                                  .list = args.list,
                                  .breaks = args.breaks,
                                  .shifts = args.shifts,
                                  .carried = args.carried,
                                  .memory = args.memory});
}

void Stages::carry_runs(const CarryRunsArgs& args) {
    launch<kernels::carry_runs>(
        args.run_capacity, tuning_.local_size,
        {.count = args.run_capacity, .first = args.first, .viewport = {}, .frame = 0, .limit = 0},
        {.arcs = args.arcs, .carried = args.carried, .record = args.record, .runs = args.runs});
}

} // namespace lineatlas::compute
