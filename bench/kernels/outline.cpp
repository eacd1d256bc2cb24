// outline, outline_push, pens: n segments in paths (paths.hpp) before stripes of background.
// outline takes samples of the segment atlas, outline_push is the first step of the method exact.
// Bytes of outline: per segment the segment (32), its clipped segment (48) and two offsets (8), per
// sample its texels (16), all of these twice, for counting and for writing; per part 8.
// Bytes of outline_push: per segment its tag (4), two offsets and two arc lengths (16), its number
// written and read three times (16); per segment that is seen the segment (32), its clipped segment
// twice (96), two clipped segments (96) and four more (192) written, offsets of their visible spans
// twice (64), these spans (32) and parts written (16).
// Bytes of pens: per run twice the run (80) and its pens (4), per resulting run 80.

#include <algorithm>

#include "paths.hpp"

namespace lineatlas::bench {
namespace {

constexpr glm::ivec2 depth_size{2048, 1536};
constexpr float depth_scale = 2;
constexpr float body = 6; // least depth of a body, in pixels

/// Stripes of 16 texels, by turns with a body and without.
std::vector<float> striped_depth() {
    std::vector<float> depth;
    depth.reserve(static_cast<std::size_t>(depth_size.x) * static_cast<std::size_t>(depth_size.y));
    for (int y = 0; y < depth_size.y; ++y) {
        for (int x = 0; x < depth_size.x; ++x) depth.push_back((x + y) / 16 % 2 == 0 ? 0.5F : 1.0F);
    }
    return depth;
}

/// Paths, and the parts of them with background on one side.
struct Outlines {
    Outlines(compute::Stages& stages, const Paths& from)
        : device(stages.device()), paths(device, from), depth(to_device(device, striped_depth())),
          capacity(paths.samples),
          offsets(device.allocate((paths.count + std::size_t{1}) * sizeof(std::uint32_t))),
          parts(device.allocate(std::size_t{capacity} * 2 * sizeof(float))) {
        find(stages);
    }

    void find(compute::Stages& stages) const {
        stages.outline_samples({.table = paths.table(),
                                .clipped = paths.atlas().clipped,
                                .sample_capacity = paths.samples,
                                .depth = {*depth, depth_size, depth_scale, 1e-4F},
                                .viewport = Paths::viewport,
                                .body = body,
                                .part_offsets = *offsets,
                                .parts = *parts,
                                .part_capacity = capacity});
    }
    compute::OutlineTable table() const { return {*offsets, *parts}; }
    std::uint32_t found() const {
        return read_back<std::uint32_t>(device, *offsets, paths.count + std::size_t{1}).back();
    }

    compute::Device& device;
    PathTables paths;
    SharedBuffer depth;
    std::uint32_t capacity;
    SharedBuffer offsets, parts;
};

Job prepare_outline(compute::Stages& stages, std::uint32_t n) {
    const auto on = std::make_shared<Outlines>(stages, make_paths(n));
    const auto run = [&stages, on] {
        on->find(stages);
        stages.device().finish();
    };
    run();
    const std::uint32_t found = on->found();
    require(found > 0 && found < on->capacity, "outline");
    return {.run = run,
            .bytes = 176.0 * n + 32.0 * on->paths.samples + 8.0 * found,
            .result = [on, found] {
                return read_back<float>(on->device, *on->parts, 2 * std::size_t{found});
            }};
}

Job prepare_push(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const PathTables on{device, make_paths(n)};
    const std::size_t beside = LA_OUTLINE_BESIDE * std::size_t{n};
    const std::size_t count = LA_OUTLINE_WITHIN * std::size_t{n};
    const SharedBuffer pushed = to_device(device, std::vector<ClippedSegment>(count));
    // Each way beside a segment has one visible span, each way within a body has none.
    std::vector<std::uint32_t> one_each(beside + 1);
    std::ranges::generate(one_each, [next = 0U]() mutable { return next++; });
    const SharedBuffer offsets = to_device(device, one_each);
    const SharedBuffer spans = to_device(device, std::vector<glm::vec2>(beside, {1, 2}));
    const SharedBuffer nothing = to_device(device, std::vector<std::uint32_t>(count + 1));
    const SharedBuffer part_offsets = to_device(device, std::vector<std::uint32_t>(n + 1));
    const SharedBuffer parts = to_device(device, std::vector<glm::vec2>(beside));
    const SharedBuffer numbers = to_device(device, std::vector<std::uint32_t>(n + 1));
    const SharedBuffer listed = to_device(device, std::vector<std::uint32_t>(n));
    const auto find_seen = [=, &stages] {
        // Segments with samples count as seen.
        stages.outline_seen(on.table(), on.atlas().clipped, {*on.offsets, *on.alpha, on.samples},
                            *numbers);
    };
    find_seen();
    const auto seen = read_back<std::uint32_t>(device, *numbers, n + std::size_t{1}).back();
    const std::uint32_t most = LA_OUTLINE_BESIDE * seen;
    const auto run = [=, &stages] {
        find_seen();
        stages.launch_each<compute::kernels::scan_list>(n, {.values = *numbers, .list = *listed});
        const compute::OutlineParameters outline{.count = seen,
                                                 .viewport = Paths::viewport,
                                                 .reach = 0.5F,
                                                 .depth = body,
                                                 .parallel = 0,
                                                 .capacity = 0,
                                                 .clip_from_world = glm::mat4{1},
                                                 .lift = 0};
        stages.launch<compute::kernels::outline_push>(seen, outline,
                                                      {.segments = *on.segments,
                                                       .seen = *listed,
                                                       .vertices = *on.vertices,
                                                       .clipped = *on.clipped,
                                                       .pushed = *pushed});
        stages.launch<compute::kernels::outline_push_in>(seen, outline,
                                                         {.seen = *listed,
                                                          .clipped = *on.clipped,
                                                          .beside_offsets = *offsets,
                                                          .pushed = *pushed});
        stages.outline_parts({.segment_count = n,
                              .numbers = *numbers,
                              .arcs = *on.arcs,
                              .depth = body,
                              .beside = {*offsets, *spans, most},
                              .within = {*nothing, *spans, most},
                              .part_offsets = *part_offsets,
                              .parts = *parts,
                              .part_capacity = most});
        stages.device().finish();
    };
    run();
    require(read_back<std::uint32_t>(device, *part_offsets, n + std::size_t{1}).back() == most,
            "outline_parts");
    const auto result = [&device, pushed, count] {
        std::vector<float> places;
        for (const ClippedSegment& side : read_back<ClippedSegment>(device, *pushed, count)) {
            const bool looked_for = side.p[3] != 0;
            places.push_back(looked_for ? side.p[0] / side.p[3] : 0.0F);
            places.push_back(looked_for ? side.q[1] / side.q[3] : 0.0F);
        }
        return places;
    };
    require(std::ranges::any_of(result(), [](float place) { return place != 0; }), "outline_push");
    return {.run = run, .bytes = 36.0 * n + 528.0 * seen, .result = result};
}

Job prepare_pens(compute::Stages& stages, std::uint32_t n) {
    const auto on = std::make_shared<Outlines>(stages, make_paths(n));
    compute::Device& device = on->device;
    const RunTables from{device, on->paths.runs}, to{device, on->paths.runs + 2 * on->found()};
    compact(stages, on->paths, from);
    constexpr std::uint32_t first_inside_second_outside = 1U << 16U;
    const SharedBuffer pens =
        to_device(device, std::vector<std::uint32_t>(n, first_inside_second_outside));
    const auto run = [=, &stages] {
        const compute::OutlineTable outline = on->table();
        stages.pens({.table = on->paths.table(),
                     .segment_pens = *pens,
                     .outline = &outline,
                     .runs = {*from.runs, *from.record, from.capacity},
                     .drawn = {*to.runs, *to.record, to.capacity}});
        stages.device().finish();
    };
    run();
    const auto result = [&device, to] { return members(to.read(device), &Run::flags); };
    const auto written = static_cast<double>(to.read(device).size());
    require(written > from.capacity, "pens");
    return {.run = run, .bytes = 168.0 * from.capacity + 80.0 * written, .result = result};
}

} // namespace

Rows outline_rows(const Devices& devices) {
    Rows rows = own_rows(devices, "outline", prepare_outline);
    std::ranges::move(own_rows(devices, "outline_push", prepare_push), std::back_inserter(rows));
    return rows;
}

Rows pens_rows(const Devices& devices) {
    return own_rows(devices, "pens", prepare_pens);
}

} // namespace lineatlas::bench
