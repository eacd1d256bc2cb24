// halo and density: about n samples in runs of 1 to 15, in paths of 16 runs, at two depths, strewn
// over a picture of 64 pixels per run. Bytes of halo, per run: the run (80), its segment (32), its
// clipped segment (48), the cuts (64), and an entry of 24 bytes written and read for each of about
// three tiles. Bytes of density: per run the run read and written (160) and its segment (32), and
// every sample. The grid has 16 bins of 4 bytes per cell. It is written, smoothed (read and
// written) and read; the weights, as large as the grid, are written once.

#include <algorithm>
#include <cmath>

#include "common.hpp"

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
    const std::uint32_t count = n / 8; // a run has 8 samples on average
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
    Buffers(compute::Device& device, const Input& input)
        : none(device.allocate(16)), segments(to_device(device, input.segments)),
          clipped(to_device(device, input.clipped)), arcs(to_device(device, input.arcs)),
          alpha(to_device(device, input.alpha)), runs(to_device(device, input.runs)),
          count(static_cast<std::uint32_t>(input.runs.size())), viewport(input.viewport) {
        const FrameRecord values{.points = {count, 1, 0, 0},
                                 .sample_total = 0,
                                 .run_total = count,
                                 .raw_run_total = count,
                                 .unused = 0};
        record = to_device(device, std::vector{values});
    }
    compute::SegmentTable table() const { return {*none, *none, *segments, 0, count}; }
    compute::ClippedTable clipped_table() const { return {*clipped, *none, *arcs}; }

    SharedBuffer none, segments, clipped, arcs, alpha, runs, record;
    std::uint32_t count;
    glm::vec2 viewport;
};

Job prepare_halo(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Buffers on{device, make_input(n)};
    const SharedBuffer cuts = device.allocate(on.count * sizeof(RunCuts));
    const auto run = [on, cuts, &stages] {
        stages.halo({.table = on.table(),
                     .clipped = on.clipped_table(),
                     .runs = {*on.runs, *on.record, on.count},
                     .viewport = on.viewport,
                     .halo = halo_width,
                     .half_width = half_width,
                     .tolerance = tolerance,
                     .cuts = *cuts});
        stages.device().finish();
    };
    run();
    const auto result = [&device, on, cuts] {
        return read_back<float>(device, *cuts, on.count * sizeof(RunCuts) / sizeof(float));
    };
    const std::vector<float> found = result();
    require(std::ranges::any_of(found, [](float arc) { return arc > 0; }), "halo");
    return {.run = run, .bytes = 368.0 * on.count, .result = result};
}

Job prepare_density(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Buffers on{device, make_input(n)};
    const glm::ivec2 cells = compute::density_cells(on.viewport);
    const std::size_t count =
        LA_DENSITY_BINS * static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y);
    const SharedBuffer weights = device.allocate(count * sizeof(float));
    const SharedBuffer grid = device.allocate(count * sizeof(std::uint32_t));
    const auto run = [=, &stages] {
        stages.density({.table = on.table(),
                        .atlas = {on.clipped_table(), *on.alpha, 0},
                        .runs = {*on.runs, *on.record, on.count},
                        .viewport = on.viewport,
                        .density = {.limit = 0.1F},
                        .focus = glm::vec4{0},
                        .far_limit = 1,
                        .grid = *grid,
                        .weights = *weights});
        stages.device().finish();
    };
    run();
    const auto result = [&device, weights, count] {
        return read_back<float>(device, *weights, count);
    };
    const std::vector<float> found = result();
    require(std::ranges::any_of(found, [](float weight) { return weight > 0 && weight < 1; }),
            "density");
    return {.run = run,
            .bytes = 192.0 * on.count + n + 5 * 4.0 * static_cast<double>(count),
            .result = result};
}

} // namespace

Rows halo_rows(const Devices& devices) {
    return own_rows(devices, "halo", prepare_halo);
}

Rows density_rows(const Devices& devices) {
    return own_rows(devices, "density", prepare_density);
}

} // namespace lineatlas::bench
