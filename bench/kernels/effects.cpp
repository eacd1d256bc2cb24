// halo and density: n samples in runs of 1 to 15, strewn over a picture of 64 pixels per run, in
// paths of 16 runs and at two depths. Bytes per run: halo reads the run (80), its segment (32) and
// its clipped segment (48), writes the cuts (64), writes and reads the lists (24 for each of about
// three tiles); density reads and writes the run (80) and reads its segment (32) and samples. Its
// grid has 16 bins of 4 bytes per cell and is written, smoothed (read and written) and read, and
// the weights are as large.

#include <algorithm>
#include <cmath>

#include "common.hpp"
#include "compute/reference/stages.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::uint32_t path_length = 16;
constexpr float tolerance = 1e-4F, halo_width = 3, half_width = 1;

struct Input {
    glm::vec2 viewport{};
    std::vector<Segment> segments;
    std::vector<ClippedSegment> clipped;
    std::vector<std::uint32_t> arcs{0};
    std::vector<std::uint8_t> alpha;
    std::vector<Run> runs;
};

Input make_input(std::uint32_t n) {
    const std::uint32_t count = n / 8; // half of the most samples of a run
    Random random{9};
    Input input;
    const float side = std::ceil(std::sqrt(64.0F * static_cast<float>(count)));
    input.viewport = {side, side};
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t samples = 1 + random.below(15);
        const float length = 2 * static_cast<float>(samples);
        const float angle = random.between(0, 6.2831853F);
        const float depth = random.below(2) == 0 ? 0.4F : 0.6F;
        const glm::vec2 start{random.between(0, side), random.between(0, side)};
        const glm::vec2 end = start + length * glm::vec2{std::cos(angle), std::sin(angle)};
        const std::uint32_t in_path = i % path_length;
        input.segments.push_back({.p = 2 * i,
                                  .q = 2 * i + 1,
                                  .face_a = LA_NO_FACE,
                                  .face_b = LA_NO_FACE,
                                  .from_start = in_path,
                                  .to_end = std::min(path_length - 1 - in_path, count - 1 - i),
                                  .path = i / path_length,
                                  .tag = i / path_length % LA_KIND_COUNT});
        input.clipped.push_back(
            {.p = {0, 0, 0, 1}, .q = {0, 0, 0, 1}, .t0 = 0, .t1 = 1, .own_a = 0, .own_b = 0});
        input.arcs.push_back(input.arcs.back() +
                             static_cast<std::uint32_t>(length * LA_ARC_UNITS_PER_PIXEL));
        Run run{};
        run.start[0] = start.x;
        run.start[1] = start.y;
        run.end[0] = end.x;
        run.end[1] = end.y;
        run.end_arc = run.stroke_end = length;
        run.end_sample = static_cast<float>(samples);
        run.address = static_cast<std::uint32_t>(input.alpha.size());
        run.samples = samples;
        run.flags = LA_END_HIDDEN << LA_RUN_START_SHIFT | LA_END_PATH << LA_RUN_END_SHIFT;
        run.segment = i;
        run.start_depth = run.end_depth = depth;
        input.runs.push_back(run);
        input.alpha.insert(input.alpha.end(), samples, 255);
    }
    return input;
}

/// A picture's buffers.
struct Buffers {
    Buffers(compute::Backend& backend, const Input& input)
        : none(backend.allocate(16)), segments(to_device(backend, input.segments)),
          clipped(to_device(backend, input.clipped)), arcs(to_device(backend, input.arcs)),
          alpha(to_device(backend, input.alpha)), runs(to_device(backend, input.runs)),
          count(static_cast<std::uint32_t>(input.runs.size())), viewport(input.viewport) {
        const FrameRecord values{.points = {count, 1, 0, 0},
                                 .quads = {4, count, 0, 0},
                                 .sample_total = 0,
                                 .run_total = count,
                                 .raw_run_total = count,
                                 .unused = 0};
        record = to_device(backend, std::vector{values});
    }
    compute::SegmentTable table() const { return {*none, *none, *segments, 0, count}; }
    compute::ClippedTable clipped_table() const { return {*clipped, *none, *arcs}; }

    SharedBuffer none, segments, clipped, arcs, alpha, runs, record;
    std::uint32_t count;
    glm::vec2 viewport;
};

Job prepare_halo(compute::Backend& backend, std::uint32_t n) {
    const Input input = make_input(n);
    const Buffers on{backend, input};
    const std::uint32_t count = on.count;
    const SharedBuffer cuts = backend.allocate(count * sizeof(RunCuts));
    const auto run = [on, cuts, count, &backend] {
        backend.halo({.table = on.table(),
                      .clipped = on.clipped_table(),
                      .runs = *on.runs,
                      .record = *on.record,
                      .run_capacity = count,
                      .viewport = on.viewport,
                      .halo = halo_width,
                      .half_width = half_width,
                      .tolerance = tolerance,
                      .cuts = *cuts});
        backend.finish();
    };
    run();
    std::vector<RunCuts> expected(count);
    compute::reference::halo({.segments = input.segments,
                              .clipped = input.clipped,
                              .runs = input.runs,
                              .viewport = input.viewport,
                              .width = halo_width + half_width,
                              .tolerance = tolerance},
                             expected);
    const auto cut_runs = [](const std::vector<RunCuts>& all) {
        return std::ranges::count_if(all, [](const RunCuts& c) { return c.from[0] != c.to[0]; });
    };
    const auto wanted = cut_runs(expected),
               seen = cut_runs(read_back<RunCuts>(backend, *cuts, count));
    // Where a line just reaches another, rounding decides.
    require(wanted > 0 && std::abs(wanted - seen) <= count / 10000, "halo");
    return {.run = run, .bytes = 368.0 * count};
}

Job prepare_density(compute::Backend& backend, std::uint32_t n) {
    Input input = make_input(n);
    const Buffers on{backend, input};
    const glm::ivec2 cells = compute::density_cells(on.viewport);
    const std::size_t count =
        LA_DENSITY_BINS * static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y);
    const SharedBuffer weights = backend.allocate(count * sizeof(float));
    constexpr float limit = 0.1F;
    constexpr float priority[LA_KIND_COUNT]{0.5F, 0.6F, 0.5F, 1, 1};
    const AtlasLayout layout = make_atlas_layout(AtlasLayoutKind::wrap, 7, 16384);
    const auto run = [=, &backend] {
        compute::DensityArgs args{.table = on.table(),
                                  .clipped = on.clipped_table(),
                                  .alpha = *on.alpha,
                                  .layout = layout,
                                  .runs = *on.runs,
                                  .record = *on.record,
                                  .run_capacity = on.count,
                                  .viewport = on.viewport,
                                  .limit = limit,
                                  .priority = {},
                                  .focus = glm::vec4{0},
                                  .far_limit = 1,
                                  .weights = *weights};
        std::ranges::copy(priority, args.priority);
        backend.density(args);
        backend.finish();
    };
    run();
    std::vector<float> expected(count);
    compute::reference::density({.segments = input.segments,
                                 .arcs = input.arcs,
                                 .alpha = input.alpha,
                                 .viewport = input.viewport,
                                 .limit = limit,
                                 .priority = priority,
                                 .focus = glm::vec4{0},
                                 .far_limit = 1},
                                input.runs, expected);
    require(std::ranges::equal(expected, read_back<float>(backend, *weights, count),
                               [](float a, float b) { return std::fabs(a - b) < 1e-3F; }),
            "density");
    return {.run = run, .bytes = 192.0 * on.count + n + 5 * 4.0 * static_cast<double>(count)};
}

} // namespace

Rows halo_rows(const Backends& backends) {
    return own_rows(backends, "halo", prepare_halo);
}

Rows density_rows(const Backends& backends) {
    return own_rows(backends, "density", prepare_density);
}

} // namespace lineatlas::bench
