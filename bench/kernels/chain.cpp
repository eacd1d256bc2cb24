// silhouette, silhouette_list, chain: n candidates in rings of 64 edges, in random order. All edges
// of every second ring are silhouettes. Bytes of silhouette, per candidate: the segment (32), its
// two faces (2) and the result (4). Bytes of silhouette_list: the number and position of each
// candidate (8), the index of each silhouette (4). Bytes of chain, per silhouette: its segment
// twice (64), its ends and the ends that they meet (32), two ways of 16 bytes read and written in
// each of 8 steps (512), its place written and read (32), and its number, start and origin (16).

#include <algorithm>
#include <numeric>

#include "common.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::uint32_t ring = 64;

/// The input of all three stages.
struct Rings {
    Rings(compute::Stages& stages, std::uint32_t n)
        : device(stages.device()), count(n),
          numbers(device.allocate((n + std::size_t{1}) * sizeof(std::uint32_t))) {
        std::vector<std::uint32_t> order(n);
        std::iota(order.begin(), order.end(), 0U);
        Random random{3};
        for (std::uint32_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
        std::vector<Segment> list(n);
        std::vector<std::uint32_t> at(2 * std::size_t{n});
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t first = i / ring * ring, length = std::min(ring, n - first);
            const std::uint32_t shown = i / ring % 2 == 0 ? 1 : 0;
            const std::uint32_t p = i, q = first + (i - first + 1) % length;
            list[order[i]] = {.p = p,
                              .q = q,
                              .face_a = 0,
                              .face_b = shown,
                              .from_start = 0,
                              .to_end = 0,
                              .path = order[i],
                              .tag = LA_KIND_SILHOUETTE};
            silhouettes += shown;
            at[2 * std::size_t{p} + 1] = 2 * order[i];
            at[2 * std::size_t{q}] = 2 * order[i] + 1;
        }
        std::vector<std::uint32_t> offsets(n + std::size_t{1});
        for (std::uint32_t v = 0; v <= n; ++v) offsets[v] = 2 * v;
        segments = to_device(device, list);
        end_offsets = to_device(device, offsets);
        ends = to_device(device, at);
        vertices = to_device(device, std::vector<float>(3 * std::size_t{n}));
        front = to_device(device, std::vector<std::uint8_t>{1, 0});
    }

    compute::SegmentTable table() const {
        return {*vertices, *vertices, *segments,
                2,         count,     {0, count, end_offsets.get(), ends.get()}};
    }

    compute::Device& device;
    std::uint32_t count, silhouettes = 0;
    SharedBuffer segments, end_offsets, ends, vertices, front, numbers;
};

Job prepare_silhouette(compute::Stages& stages, std::uint32_t n) {
    const auto rings = std::make_shared<Rings>(stages, n);
    const auto run = [&stages, rings] {
        stages.silhouette(
            {.table = rings->table(), .front = *rings->front, .numbers = *rings->numbers});
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = 38.0 * n, .result = [rings, n] {
                return read_back<std::uint8_t>(rings->device, *rings->numbers,
                                               (n + std::size_t{1}) * sizeof(std::uint32_t));
            }};
}

Job prepare_list(compute::Stages& stages, std::uint32_t n) {
    const auto rings = std::make_shared<Rings>(stages, n);
    stages.silhouette(
        {.table = rings->table(), .front = *rings->front, .numbers = *rings->numbers});
    const std::size_t count = rings->silhouettes;
    const SharedBuffer chosen{rings->device.allocate(count * sizeof(std::uint32_t))},
        positions{rings->device.allocate(n * sizeof(std::uint32_t))};
    const auto run = [=, &stages] {
        stages.silhouette_list({.candidates = rings->table().candidates,
                                .numbers = *rings->numbers,
                                .chosen = *chosen,
                                .positions = *positions});
        stages.device().finish();
    };
    run();
    return {.run = run,
            .bytes = 8.0 * n + 4.0 * static_cast<double>(count),
            .result = [rings, chosen, count] {
                return read_back<std::uint8_t>(rings->device, *chosen,
                                               count * sizeof(std::uint32_t));
            }};
}

Job prepare_chain(compute::Stages& stages, std::uint32_t n) {
    const auto rings = std::make_shared<Rings>(stages, n);
    stages.silhouette(
        {.table = rings->table(), .front = *rings->front, .numbers = *rings->numbers});
    const std::size_t count = rings->silhouettes;
    const auto words = [&](std::size_t each) {
        return SharedBuffer{rings->device.allocate(each * sizeof(std::uint32_t))};
    };
    const SharedBuffer chosen = words(count), ways = words(8 * count), longer = words(8 * count),
                       going = words(compute::most_chain_steps), places = words(4 * count),
                       starts = words(count + 1), ordered = words(8 * count),
                       origins = words(count), positions = words(n);
    stages.silhouette_list({.candidates = rings->table().candidates,
                            .numbers = *rings->numbers,
                            .chosen = *chosen,
                            .positions = *positions});
    const auto run = [=, &stages] {
        stages.chain({.table = rings->table(),
                      .crossings = nullptr,
                      .lifted = false,
                      .view = {{0, 0, 1, 0}, true},
                      .numbers = *rings->numbers,
                      .count = rings->silhouettes,
                      .chosen = *chosen,
                      .ways = *ways,
                      .longer = *longer,
                      .going = *going,
                      .places = *places,
                      .starts = *starts,
                      .ordered = *ordered,
                      .origins = *origins,
                      .positions = *positions});
        stages.device().finish();
    };
    run();
    return {
        .run = run, .bytes = 656.0 * static_cast<double>(count), .result = [rings, ordered, count] {
            return read_back<std::uint8_t>(rings->device, *ordered, count * sizeof(Segment));
        }};
}

} // namespace

Rows silhouette_rows(const Devices& devices) {
    Rows rows = own_rows(devices, "silhouette", prepare_silhouette);
    std::ranges::move(own_rows(devices, "silhouette_list", prepare_list), std::back_inserter(rows));
    return rows;
}

Rows chain_rows(const Devices& devices) {
    return own_rows(devices, "chain", prepare_chain);
}

} // namespace lineatlas::bench
