// transform: n vertices of 500 objects, with a cluster per 32 vertices. Each object has a matrix.
// Bytes: per vertex its position at rest (12), its object (4) and two moved positions (24); per
// cluster its two boxes (64) and its object (4).

#include <algorithm>
#include <iterator>

#include <glm/ext/matrix_transform.hpp>

#include "terrain.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::uint32_t object_count = 500;
constexpr std::uint32_t vertices_per_cluster = 32;

std::uint32_t cluster_count(std::uint32_t n) {
    return n / vertices_per_cluster;
}

double bytes_of(std::uint32_t n) {
    return 40.0 * n + 68.0 * cluster_count(n);
}

/// The object that vertex i of n belongs to.
std::uint32_t object_of(std::uint32_t i, std::uint32_t n) {
    return static_cast<std::uint32_t>(std::uint64_t{i} * object_count / n);
}

struct Input {
    std::vector<glm::vec3> rest;
    std::vector<std::uint32_t> objects;
    std::vector<float> matrices; ///< three rows of 4 per object
    std::vector<Cluster> clusters;
    std::vector<std::uint32_t> cluster_objects;
};

Input make_input(std::uint32_t n) {
    Random random{11};
    Input input;
    for (std::uint32_t i = 0; i < n; ++i) {
        input.rest.emplace_back(random.between(-9, 9), random.between(0, 3), random.between(-9, 9));
        const std::uint32_t object = object_of(i, n);
        input.objects.push_back(object);
        if (i % vertices_per_cluster != 0 || input.clusters.size() == cluster_count(n)) continue;
        const glm::vec3 low = input.rest.back();
        input.clusters.push_back({.low = {low.x, low.y, low.z},
                                  .high = {low.x + 1, low.y + 1, low.z + 1},
                                  .first = 2 * i,
                                  .count = 2 * vertices_per_cluster});
        input.cluster_objects.push_back(object);
    }
    for (std::uint32_t object = 0; object < object_count; ++object) {
        const glm::vec3 axis{random.between(-1, 1), 1, random.between(-1, 1)};
        const glm::mat4 turned = glm::rotate(glm::mat4{1}, random.between(-3, 3), axis);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) {
                input.matrices.push_back(turned[column][row]);
            }
        }
    }
    return input;
}

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Input input = make_input(n);
    const SharedBuffer rest = to_device(device, input.rest);
    const SharedBuffer objects = to_device(device, input.objects);
    const SharedBuffer matrices = to_device(device, input.matrices);
    const SharedBuffer rest_clusters = to_device(device, input.clusters);
    const SharedBuffer cluster_objects = to_device(device, input.cluster_objects);
    const SharedBuffer vertices = device.allocate(n * sizeof(glm::vec3));
    const SharedBuffer drawn = device.allocate(n * sizeof(glm::vec3));
    const SharedBuffer clusters = device.allocate(cluster_count(n) * sizeof(Cluster));
    const auto run = [=, &stages] {
        stages.launch_each<compute::kernels::transform>(n, {.rest = *rest,
                                                            .objects = *objects,
                                                            .matrices = *matrices,
                                                            .vertices = *vertices,
                                                            .drawn = *drawn});
        stages.launch_each<compute::kernels::transform_boxes>(cluster_count(n),
                                                              {.rest = *rest_clusters,
                                                               .objects = *cluster_objects,
                                                               .matrices = *matrices,
                                                               .clusters = *clusters});
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = bytes_of(n), .result = [&device, drawn, n] {
                return read_back<float>(device, *drawn, std::size_t{3} * n);
            }};
}

/// transform_bounds: n triangles of a terrain in clusters of 64. Bytes: per triangle its three
/// indices (12), per cluster the cluster read and written (64), every vertex (12) once.
Job prepare_bounds(compute::Stages& stages, std::uint32_t n) {
    constexpr std::uint32_t triangles_per_cluster = 64;
    compute::Device& device = stages.device();
    const Terrain terrain = make_terrain(n, 0);
    std::vector<Cluster> values(n / triangles_per_cluster);
    for (std::uint32_t i = 0; i < values.size(); ++i) {
        values[i] = {.low = {},
                     .high = {},
                     .first = i * triangles_per_cluster,
                     .count = triangles_per_cluster};
    }
    const auto count = static_cast<std::uint32_t>(values.size());
    const SharedBuffer vertices = to_device(device, terrain.vertices);
    const SharedBuffer triangles = to_device(device, terrain.triangles);
    const SharedBuffer clusters = to_device(device, values);
    const auto run = [=, &stages] {
        stages.launch_each<compute::kernels::transform_bounds>(
            count, {.vertices = *vertices, .triangles = *triangles, .clusters = *clusters});
        stages.device().finish();
    };
    run();
    return {.run = run,
            .bytes = 12.0 * n + 64.0 * count + 12.0 * terrain.vertex_count,
            .result = [&device, clusters, count] {
                return read_back<std::uint8_t>(device, *clusters, count * sizeof(Cluster));
            }};
}

/// transform_forget: n segments of 500 objects. Every third object has jumped. Bytes: per segment
/// the segment (32) and the object of its start (4); per segment of a jumped object its range (4).
Job prepare_forget(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    std::vector<Segment> values(n);
    std::vector<std::uint32_t> object_values(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        values[i].p = i;
        object_values[i] = object_of(i, n);
    }
    std::vector<std::uint8_t> jumped_values(object_count);
    for (std::uint32_t i = 0; i < object_count; i += 3) jumped_values[i] = 1;
    const SharedBuffer segments = to_device(device, values);
    const SharedBuffer objects = to_device(device, object_values);
    const SharedBuffer jumped = to_device(device, jumped_values);
    const SharedBuffer ranges = to_device(device, std::vector<std::uint32_t>(n, ~0U));
    const auto run = [=, &stages] {
        stages.launch_each<compute::kernels::transform_forget>(
            n, {.segments = *segments, .objects = *objects, .jumped = *jumped, .ranges = *ranges});
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = 36.0 * n + 4.0 / 3.0 * n, .result = [&device, ranges, n] {
                return read_back<std::uint8_t>(device, *ranges, n * sizeof(std::uint32_t));
            }};
}

} // namespace

Rows transform_rows(const Devices& devices) {
    Rows rows = own_rows(devices, "transform", prepare);
    rows.push_back(copy_row(devices, "transform", bytes_of));
    std::ranges::move(own_rows(devices, "transform_bounds", prepare_bounds),
                      std::back_inserter(rows));
    std::ranges::move(own_rows(devices, "transform_forget", prepare_forget),
                      std::back_inserter(rows));
    return rows;
}

} // namespace lineatlas::bench
