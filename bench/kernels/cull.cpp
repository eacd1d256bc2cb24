// cull: n clusters strewn over a picture and a little beyond it. Half of them lie behind its depth.
// Bytes: per cluster its box (32) and the result (4), every tile (4) once.

#include <glm/ext/matrix_clip_space.hpp>

#include "common.hpp"

namespace lineatlas::bench {
namespace {

constexpr glm::ivec2 depth_size{2048, 1536};

struct Input {
    std::vector<Cluster> clusters;
    std::vector<float> tiles; ///< one depth everywhere
    glm::mat4 clip_from_world;
};

std::size_t tile_count() {
    const glm::ivec2 tiles = compute::tiles_for(depth_size);
    return static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y);
}

double bytes_of(std::uint32_t n) {
    return 36.0 * n + 4.0 * static_cast<double>(tile_count());
}

/// Boxes of 5 to 50 texels at distances of 4 to 6 from the eye. The depth buffer holds distance 5.
Input make_input(std::uint32_t n) {
    Random random{7};
    Input input{.clusters = std::vector<Cluster>(n),
                .tiles = {},
                .clip_from_world = glm::perspective(0.9F, 4.0F / 3.0F, 0.1F, 10.0F)};
    const glm::vec4 wall = input.clip_from_world * glm::vec4{0, 0, -5, 1};
    input.tiles.assign(tile_count(), wall.z / wall.w * 0.5F + 0.5F);
    for (Cluster& cluster : input.clusters) {
        const float low[3] = {random.between(-3.4F, 3.3F), random.between(-2.6F, 2.5F),
                              random.between(-6, -4)};
        const float side = random.between(0.015F, 0.15F);
        cluster = {.low = {low[0], low[1], low[2]},
                   .high = {low[0] + side, low[1] + side, low[2] + side},
                   .first = 0,
                   .count = 64};
    }
    return input;
}

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Input input = make_input(n);
    const SharedBuffer clusters = to_device(device, input.clusters);
    const SharedBuffer tiles = to_device(device, input.tiles);
    const SharedBuffer visible = device.allocate(n * sizeof(std::uint32_t));
    const auto run = [&stages, clusters, tiles, visible, n,
                      clip_from_world = input.clip_from_world] {
        stages.launch<compute::kernels::cull>(
            n,
            {.count = n,
             .clip_from_world = clip_from_world,
             .depth_size = depth_size,
             .tile_count = compute::tiles_for(depth_size)},
            {.clusters = *clusters, .tiles = *tiles, .visible = *visible});
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = bytes_of(n), .result = [&device, visible, n] {
                return read_back<std::uint8_t>(device, *visible, std::size_t{4} * n);
            }};
}

} // namespace

Rows cull_rows(const Devices& devices) {
    Rows rows = own_rows(devices, "cull", prepare);
    rows.push_back(copy_row(devices, "cull", bytes_of));
    return rows;
}

} // namespace lineatlas::bench
