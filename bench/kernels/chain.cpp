// silhouette, silhouette_list, chain: n candidates in rings of 64 edges, in random order. All edges
// of every second ring are silhouettes. Bytes of silhouette, per candidate: the segment (32), its
// two faces (2) and the result (4). Bytes of silhouette_list: the number and position of each
// candidate (8), the index of each silhouette (4). Bytes of chain, per silhouette: its segment
// twice (64), its ends and the ends that they meet (32), two ways of 16 bytes read and written in
// each of 8 steps (512), its place written and read (32), and its number, start and origin (16).

#include <algorithm>
#include <numeric>

#include "common.hpp"
#include "compute/stages/silhouette_chains.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::uint32_t ring = 64;

/// The input of all three stages.
struct Rings {
    Rings(compute::Stages& stages, std::uint32_t n) : device(stages.device()), count(n) {
        tables.numbers.fit((n + std::size_t{1}) * sizeof(std::uint32_t));
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
    SharedBuffer segments, end_offsets, ends, vertices, front;
    compute::ChainTables tables{&device};
};

Job prepare_silhouette(compute::Stages& stages, std::uint32_t n) {
    const auto rings = std::make_shared<Rings>(stages, n);
    const auto run = [&stages, rings] {
        stages.silhouette(rings->table(), *rings->front, rings->tables);
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = 38.0 * n, .result = [rings, n] {
                return read_back<std::uint8_t>(rings->device, *rings->tables.numbers,
                                               (n + std::size_t{1}) * sizeof(std::uint32_t));
            }};
}

Job prepare_list(compute::Stages& stages, std::uint32_t n) {
    const auto rings = std::make_shared<Rings>(stages, n);
    stages.silhouette(rings->table(), *rings->front, rings->tables);
    const std::size_t count = rings->silhouettes;
    rings->tables.chosen.fit(count * sizeof(std::uint32_t));
    rings->tables.positions.fit(n * sizeof(std::uint32_t));
    rings->tables.total.fit(sizeof(std::uint32_t));
    const auto run = [=, &stages] {
        stages.silhouette_list(rings->table().candidates, rings->silhouettes, rings->tables);
        stages.device().finish();
    };
    run();
    return {
        .run = run, .bytes = 8.0 * n + 4.0 * static_cast<double>(count), .result = [rings, count] {
            return read_back<std::uint8_t>(rings->device, *rings->tables.chosen,
                                           count * sizeof(std::uint32_t));
        }};
}

Job prepare_chain(compute::Stages& stages, std::uint32_t n) {
    const auto rings = std::make_shared<Rings>(stages, n);
    stages.silhouette(rings->table(), *rings->front, rings->tables);
    const std::size_t count = rings->silhouettes;
    compute::ChainTables& tables = rings->tables;
    const auto words = [](compute::Table& table, std::size_t each) {
        table.fit(each * sizeof(std::uint32_t));
    };
    for (compute::Table* table : {&tables.ways, &tables.longer, &tables.ordered})
        words(*table, 8 * count);
    for (compute::Table* table : {&tables.chosen, &tables.origins}) words(*table, count);
    words(tables.going, compute::most_chain_steps);
    words(tables.places, 4 * count);
    words(tables.starts, count + 1);
    words(tables.positions, n);
    words(tables.total, 1);
    stages.silhouette_list(rings->table().candidates, rings->silhouettes, tables);
    const auto run = [=, &stages] {
        stages.chain({.table = rings->table(),
                      .view = {{0, 0, 1, 0}, true},
                      .lifted = false,
                      .count = rings->silhouettes,
                      .tables = rings->tables});
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = 656.0 * static_cast<double>(count), .result = [rings, count] {
                return read_back<std::uint8_t>(rings->device, *rings->tables.ordered,
                                               count * sizeof(Segment));
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
