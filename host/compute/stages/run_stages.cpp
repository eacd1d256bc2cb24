// Makes runs of visible samples, and changes them by a style.
#include <algorithm>

#include "compute/transfer.hpp"
#include "lineatlas/error.hpp"
#include "stages.hpp"

namespace lineatlas::compute {
namespace {

/// Work-items of kernels that take runs in turns: enough for a GPU.
constexpr std::uint32_t most_items_in_turns = 1U << 14U;

struct FilteredRuns {
    Buffer &filtered, &filtered_record;
};
struct OutlineTables {
    Buffer *part_offsets = nullptr, *parts = nullptr;
};

} // namespace

void Stages::compact(const CompactArgs& args) {
    const std::uint32_t n = args.table.segment_count;
    const CompactParameters parameters{.count = n,
                                       .capacity = args.atlas.capacity,
                                       .viewport = args.viewport,
                                       .half_width = args.half_width,
                                       .hidden = args.hidden ? 1U : 0U,
                                       .block = tuning_.segment_block,
                                       .blocks = divide_up(n, tuning_.segment_block),
                                       .run_capacity = args.runs.capacity};
    write_blocks<kernels::compact_count, kernels::compact_write>(
        parameters, args.table, args.atlas.clipped, args.atlas, args.runs);
}

void Stages::halo(const HaloArgs& args) {
    const glm::ivec2 tiles = (glm::ivec2{args.viewport} + (LA_HALO_TILE - 1)) / LA_HALO_TILE;
    const auto tile_count = static_cast<std::uint32_t>(tiles.x * tiles.y);
    const std::uint32_t items = std::min(args.runs.capacity, most_items_in_turns);
    HaloParameters parameters{.tiles = tiles,
                              .width = args.halo + args.half_width,
                              .tolerance = args.tolerance,
                              .total = 0};
    Buffer& ends = halo_ends_.with_room(tile_count + std::size_t{1});
    device_.clear(ends, tile_count * sizeof(la_uint));
    launch<kernels::halo_count>(items, parameters, {.counts = &ends}, args.runs);
    scan(ends, tile_count, ScanKind::saturate);
    parameters.total = read_one<la_uint>(device_, ends, tile_count);
    constexpr std::size_t tables = 7;      // of struct Lists
    if (parameters.total == 0xFFFFFFFFU) { // the value at which sums stop
        throw DeviceError(beyond_limit(purpose::halos, "over 4 billion pieces of lines",
                                       "kernels count to 4 billion"));
    }
    halo_lists_.make_room((parameters.total + std::uint64_t{tuning_.halo_lanes}) * tables *
                          sizeof(la_uint));
    Buffer& lists = *halo_lists_;
    launch<kernels::halo_fill>(items, parameters, {.ends = &ends, .memory = &lists}, args.runs);
    launch<kernels::halo_cut>(items, parameters, {.ends = &ends, .memory = &lists}, args.table,
                              args.clipped, args.runs, args);
}

void Stages::filter(const FilterArgs& args) {
    const std::uint32_t n = args.runs.capacity;
    const FilterParameters parameters{.capacity = args.atlas.capacity,
                                      .viewport = args.viewport,
                                      .half_width = args.half_width,
                                      .filter = args.filter,
                                      .use_cuts = args.cuts != nullptr ? 1U : 0U,
                                      .run_capacity = n,
                                      .filtered_capacity = args.filtered.capacity};
    Buffer& counts = run_counts_.with_room(std::size_t{n} + 1);
    const FilteredRuns filtered{args.filtered.runs, args.filtered.record};
    launch_grouped<kernels::filter_count>(n, tuning_.block_local_size, parameters,
                                          {.counts = &counts}, args.table, args.atlas.clipped,
                                          args.atlas, args, args.runs);
    scan(counts, n, ScanKind::saturate);
    launch_grouped<kernels::filter_write>(n, tuning_.block_local_size, parameters,
                                          {.run_offsets = &counts}, args.table, args.atlas.clipped,
                                          args.atlas, args, args.runs, filtered);
    launch_each<kernels::filter_show>(args.filtered.capacity, filtered, args.atlas);
    launch_each<kernels::filter_show_ends>(n, args.table, args.atlas, args.runs);
}

void Stages::outline_samples(const OutlineSamplesArgs& args) {
    // Looks at texels beside the line, not at those that its own faces reach into.
    constexpr float clearance = 0.75F; // texels, half a diagonal
    const std::uint32_t n = args.table.segment_count;
    const OutlineSamplesParameters parameters{.count = n,
                                              .viewport = args.viewport,
                                              .reach = 0.25F + clearance / args.depth.scale,
                                              .depth = args.body,
                                              .depth_size = args.depth.size,
                                              .depth_scale = args.depth.scale,
                                              .numbered = args.depth.surfaces ? 1U : 0U,
                                              .sample_capacity = args.sample_capacity,
                                              .part_capacity = args.part_capacity};
    launch<kernels::outline_samples_count>(n, parameters, {.counts = &args.part_offsets},
                                           args.table, args.clipped, args.depth.tables());
    scan(args.part_offsets, n, ScanKind::saturate);
    launch<kernels::outline_samples_write>(n, parameters, args.table, args.clipped,
                                           args.depth.tables(), args);
}

void Stages::pens(const PensArgs& args) {
    const std::uint32_t n = args.runs.capacity;
    OutlineTables outlines;
    if (args.outline != nullptr) outlines = {&args.outline->part_offsets, &args.outline->parts};
    const PensParameters parameters{.outlines = args.outline != nullptr ? 1U : 0U,
                                    .first = args.table.origins != nullptr
                                                 ? args.table.candidates.first
                                                 : args.table.segment_count,
                                    .run_capacity = n,
                                    .drawn_capacity = args.drawn.capacity};
    Buffer& counts = run_counts_.with_room(std::size_t{n} + 1);
    launch<kernels::pens_count>(n, parameters, {.counts = &counts}, args.runs, args, args.table,
                                outlines);
    scan(counts, n, ScanKind::saturate);
    launch<kernels::pens_write>(
        std::max(n, 1U), parameters,
        {.run_offsets = &counts, .drawn = &args.drawn.runs, .drawn_record = &args.drawn.record},
        args.runs, args, args.table, outlines);
}

void Stages::density(const DensityArgs& args) {
    const glm::ivec2 cells = density_cells(args.viewport);
    const auto plane = static_cast<std::uint32_t>(cells.x * cells.y);
    const std::size_t planes = std::size_t{LA_DENSITY_BINS} * plane;
    const std::uint32_t items = std::min(args.runs.capacity, most_items_in_turns);
    const auto cell = static_cast<float>(density_cell(args.viewport));
    DensityParameters parameters{.cells = cells,
                                 .cell = cell,
                                 .per_cell = 1 / cell,
                                 .density = args.density,
                                 .focus = args.focus,
                                 .far_limit = args.far_limit,
                                 .again = 0,
                                 .hidden = args.hidden ? 1U : 0U};
    Buffer& smooth = density_rows_.with_room(planes);
    Buffer& drawn = density_drawn_.with_room(plane);
    Buffer& excess = density_excesses_.with_room(plane);
    if (args.drawn_before.empty())
        device_.clear(args.grid, planes * sizeof(la_uint));
    else
        device_.upload(args.grid, std::as_bytes(args.drawn_before));
    launch<kernels::density_lines>(items, parameters, args.table, args.atlas.clipped, args.atlas,
                                   args.runs, args);
    launch<kernels::density_smooth>(LA_DENSITY_BINS * plane, parameters,
                                    {.grid = args.grid, .smooth = smooth});
    const auto share_out = [&] {
        launch<kernels::density_weights>(plane, parameters,
                                         {.grid = args.grid,
                                          .smooth = smooth,
                                          .excess = excess,
                                          .weights = args.weights,
                                          .drawn = drawn});
    };
    share_out();
    launch<kernels::density_excess>(plane, parameters, {.drawn = drawn, .excess = excess});
    parameters.again = 1;
    share_out();
}

} // namespace lineatlas::compute
