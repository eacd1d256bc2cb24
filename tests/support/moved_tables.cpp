#include "moved_tables.hpp"

#include "core/clusters.hpp"
#include "devices.hpp"

namespace lineatlas::test {

MovedTables moved_on(compute::Stages& stages, const LineSet& lines,
                     const std::vector<glm::mat4>& transforms) {
    compute::Device& device = stages.device();
    const TriangleClusters parts =
        build_clusters(lines.vertices, lines.triangles, 64, lines.objects);
    std::vector<std::uint32_t> objects;
    for (std::uint32_t i = 0; i < lines.objects.size(); ++i) {
        objects.resize(objects.size() + lines.objects[i].vertex_count, i);
    }
    std::vector<float> rows;
    for (const glm::mat4& m : transforms) {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) rows.push_back(m[column][row]);
        }
    }
    std::vector<std::uint8_t> jumped(transforms.size());
    for (std::size_t i = 0; i < jumped.size(); i += 3) jumped[i] = 1;
    const auto n = static_cast<std::uint32_t>(lines.vertices.size());
    const auto cluster_count = static_cast<std::uint32_t>(parts.clusters.size());
    const auto rest = to_device(device, lines.vertices);
    const auto object_buffer = to_device(device, objects);
    const auto matrices = to_device(device, rows);
    const auto vertices = device.allocate(n * sizeof(glm::vec3));
    const auto drawn = device.allocate(n * sizeof(glm::vec3));
    const auto rest_clusters = to_device(device, parts.clusters);
    const auto cluster_objects = to_device(device, parts.objects);
    const auto clusters = device.allocate(cluster_count * sizeof(Cluster));
    const auto triangles = to_device(device, parts.triangles);
    const auto bounds = to_device(device, parts.clusters);
    const auto segments = to_device(device, lines.segments);
    const auto jumped_buffer = to_device(device, jumped);
    const auto ranges =
        to_device(device, std::vector<std::uint32_t>(lines.segments.size(), 0xFFFF0000));
    stages.launch_each<compute::kernels::transform>(n, {.rest = *rest,
                                                        .objects = *object_buffer,
                                                        .matrices = *matrices,
                                                        .vertices = *vertices,
                                                        .drawn = *drawn});
    stages.launch_each<compute::kernels::transform_boxes>(cluster_count,
                                                          {.rest = *rest_clusters,
                                                           .objects = *cluster_objects,
                                                           .matrices = *matrices,
                                                           .clusters = *clusters});
    stages.launch_each<compute::kernels::transform_bounds>(
        cluster_count, {.vertices = *vertices, .triangles = *triangles, .clusters = *bounds});
    stages.launch_each<compute::kernels::transform_forget>(
        static_cast<std::uint32_t>(lines.segments.size()), {.segments = *segments,
                                                            .objects = *object_buffer,
                                                            .jumped = *jumped_buffer,
                                                            .ranges = *ranges});
    return {.vertices = read_back<glm::vec3>(device, *vertices, n),
            .drawn = read_back<glm::vec3>(device, *drawn, n),
            .clusters = read_back<Cluster>(device, *clusters, cluster_count),
            .bounds = read_back<Cluster>(device, *bounds, cluster_count),
            .ranges = read_back<std::uint32_t>(device, *ranges, lines.segments.size())};
}

} // namespace lineatlas::test
