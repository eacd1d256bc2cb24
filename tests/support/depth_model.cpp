#include "depth_model.hpp"

#include "core/clusters.hpp"
#include "core/meshlets.hpp"
#include "devices.hpp"
#include "segment_table.h"

namespace lineatlas::test {

DepthModel::DepthModel(compute::Device& device, const std::vector<glm::vec3>& vertices,
                       const std::vector<glm::uvec3>& triangles, std::uint32_t cluster_size)
    : device_(device), vertices_(to_device(device, vertices)) {
    TriangleClusters parts = build_clusters(vertices, triangles, cluster_size);
    const Meshlets built = build_meshlets(parts.triangles, parts.clusters, vertices.size());
    count_ = static_cast<std::uint32_t>(parts.clusters.size());
    clusters_ = to_device(device, parts.clusters);
    meshlets_ = to_device(device, built.meshlets);
    vertex_list_ = to_device(device, built.vertices);
    corners_ = to_device(device, built.corners);
    order_ = std::move(parts.order);
}

compute::DepthArgs DepthModel::args(const DepthWanted& wanted, compute::Buffer& depth,
                                    compute::Buffer& tiles, compute::Buffer& seen) const {
    const glm::ivec2 size = wanted.part.size();
    return {.model = {*clusters_, *meshlets_, *vertex_list_, *corners_, count_},
            .vertices = *vertices_,
            .clip_from_world = wanted.clip_from_world,
            .whole_size = wanted.whole_size,
            .origin = wanted.part.low,
            .size = size,
            .covered = {{0, 0}, size},
            .tiles = tiles,
            .seen = seen,
            .depth = &depth};
}

void DepthModel::draw_into(compute::Stages& stages, const DepthWanted& wanted,
                           compute::Buffer& depth, compute::Buffer& numbers,
                           compute::Buffer& blank) {
    const auto tiles =
        device_.allocate(compute::count_of_tiles(wanted.part.size()) * sizeof(float));
    const auto seen = device_.allocate(count_ * sizeof(la_uint));
    compute::DepthArgs into = args(wanted, depth, *tiles, *seen);
    into.numbers = &numbers;
    into.blank = &blank;
    stages.depth(into);
}

DrawnDepth DepthModel::draw(compute::Stages& stages, const DepthWanted& wanted) {
    const glm::ivec2 size = wanted.part.size();
    const glm::ivec2 tiles = compute::tiles_for(size);
    const auto texel_count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    const auto tile_count = static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y);
    const auto depth = to_device(device_, std::vector(texel_count, 0.125F));
    const auto pyramid = to_device(device_, std::vector(tile_count, 0.125F));
    const auto seen = to_device(device_, std::vector(count_, 7U));
    const auto numbers = to_device(device_, std::vector(texel_count, 7U));
    compute::DepthArgs into = args(wanted, *depth, *pyramid, *seen);
    if (wanted.numbered) into.numbers = numbers.get();
    if (!wanted.texels) into.depth = nullptr;
    stages.depth(into);
    std::vector<std::uint32_t> triangles;
    if (wanted.numbered) triangles = read_back<std::uint32_t>(device_, *numbers, texel_count);
    for (std::uint32_t& number : triangles)
        if (number != LA_NO_FACE) number = order_[number];
    return {.texels = read_back<float>(device_, *depth, texel_count),
            .tiles = read_back<float>(device_, *pyramid, tile_count),
            .seen = read_back<std::uint32_t>(device_, *seen, count_),
            .numbers = std::move(triangles)};
}

} // namespace lineatlas::test
