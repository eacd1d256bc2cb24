// transform: n vertices of 500 objects, with a cluster for every 32, moved by a matrix each.
// Bytes: per vertex where it was made (12), its object (4) and two places (24); per cluster its two
// boxes (64) and its object (4).

#include <glm/ext/matrix_transform.hpp>

#include "common.hpp"
#include "compute/reference/stages.hpp"

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

/// The device and plain C++ get the same.
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
        const auto object = static_cast<std::uint32_t>(std::uint64_t{i} * object_count / n);
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

Job prepare(compute::Backend& backend, std::uint32_t n) {
    const Input input = make_input(n);
    const SharedBuffer rest = to_device(backend, input.rest);
    const SharedBuffer objects = to_device(backend, input.objects);
    const SharedBuffer matrices = to_device(backend, input.matrices);
    const SharedBuffer rest_clusters = to_device(backend, input.clusters);
    const SharedBuffer cluster_objects = to_device(backend, input.cluster_objects);
    const SharedBuffer vertices = backend.allocate(n * sizeof(glm::vec3));
    const SharedBuffer drawn = backend.allocate(n * sizeof(glm::vec3));
    const SharedBuffer clusters = backend.allocate(cluster_count(n) * sizeof(Cluster));
    const auto run = [=, &backend] {
        backend.transform({.rest = *rest,
                           .objects = *objects,
                           .matrices = *matrices,
                           .vertex_count = n,
                           .vertices = *vertices,
                           .drawn = *drawn,
                           .rest_clusters = *rest_clusters,
                           .cluster_objects = *cluster_objects,
                           .cluster_count = cluster_count(n),
                           .clusters = *clusters});
        backend.finish();
    };
    run();
    std::vector<glm::vec3> expected(n);
    compute::reference::transform(input.rest, input.objects, input.matrices, expected);
    require(read_back<glm::vec3>(backend, *drawn, n) == expected, "transform");
    return {.run = run, .bytes = bytes_of(n)};
}

} // namespace

Rows transform_rows(const Backends& backends) {
    Rows rows = own_rows(backends, "transform", prepare);
    rows.push_back(copy_row(backends, "transform", bytes_of));
    return rows;
}

} // namespace lineatlas::bench
