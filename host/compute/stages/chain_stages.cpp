// Silhouettes of a frame, and the chains that they make.
#include <bit>

#include "stages.hpp"

namespace lineatlas::compute {

void Stages::silhouette(const SilhouetteArgs& args) {
    const SilhouetteCandidates& candidates = args.table.candidates;
    launch<kernels::silhouette>(
        candidates.count, tuning_.local_size,
        {.count = candidates.count, .first = candidates.first},
        {.segments = args.table.segments, .front = args.front, .numbers = args.numbers});
    scan(args.numbers, candidates.count, ScanKind::saturate);
}

void Stages::chain(const ChainArgs& args) {
    const SilhouetteCandidates& candidates = args.table.candidates;
    ChainParameters parameters{
        .count = candidates.count, .first = candidates.first, .step = 0, .eye = args.eye};
    launch<kernels::chain_link>(candidates.count, tuning_.local_size, parameters,
                                {.segments = args.table.segments,
                                 .vertices = args.table.vertices,
                                 .end_offsets = *candidates.end_offsets,
                                 .ends = *candidates.ends,
                                 .numbers = args.numbers,
                                 .chosen = args.chosen,
                                 .ways = args.ways,
                                 .positions = args.positions});
    // A stretch is twice as long after each step; that a loop is one shows when it has gone round.
    const auto steps = static_cast<std::uint32_t>(std::bit_width(args.count)) + 2;
    device_.clear(args.going, steps * sizeof(la_uint));
    parameters.count = 2 * args.count;
    Buffer* from = &args.ways;
    Buffer* to = &args.longer;
    for (parameters.step = 0; parameters.step < steps; ++parameters.step) {
        launch<kernels::chain_jump>(parameters.count, tuning_.local_size, parameters,
                                    {.ways = *from, .longer = *to, .going = args.going});
        std::swap(from, to);
    }
    parameters.count = args.count;
    launch<kernels::chain_place>(args.count, tuning_.local_size, parameters,
                                 {.ways = *from, .places = args.places, .lengths = args.starts});
    scan(args.starts, args.count, ScanKind::saturate);
    launch<kernels::chain_write>(args.count, tuning_.local_size, parameters,
                                 {.segments = args.table.segments,
                                  .chosen = args.chosen,
                                  .places = args.places,
                                  .starts = args.starts,
                                  .ordered = args.ordered,
                                  .origins = args.origins,
                                  .positions = args.positions});
}

} // namespace lineatlas::compute
