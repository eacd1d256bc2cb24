// contour: n edges between n corners of random normals, and as many triangles.
// Bytes: per edge what lies beside it (20), what its corners are (32) and where (24), the two
// places (24) and how it is crossed (1); per triangle its edges (12), how they are crossed (3) and
// its ends (8).

#include <glm/geometric.hpp>

#include "common.hpp"

namespace lineatlas::bench {
namespace {

Job prepare_contour(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    Random random{9};
    const auto component = [&] { return static_cast<float>(random.below(2001)) * 1e-3F - 1; };
    std::vector<ContourCorner> corners(n);
    std::vector<compute::ContourEdge> edges(n);
    std::vector<glm::uvec3> faces(n);
    std::vector<glm::vec3> vertices(3 * std::size_t{n});
    for (std::uint32_t i = 0; i < n; ++i) {
        const glm::vec3 normal = glm::normalize(glm::vec3{component(), component(), 1.5F});
        corners[i] = {.vertex = i, .normal = {normal.x, normal.y, component()}};
        edges[i] = {i, (i + 1) % n, 0, i, (i + 1) % n};
        faces[i] = {i, (i + 1) % n, (i + 2) % n | LA_CONTOUR_TURNED};
        vertices[i] = {component(), component(), component()};
    }
    const SharedBuffer corner_table = to_device(device, corners),
                       edge_table = to_device(device, edges), face_table = to_device(device, faces),
                       places = to_device(device, vertices), triangles = to_device(device, faces),
                       front = to_device(device, std::vector<std::uint8_t>(n, 1)),
                       crossed = SharedBuffer{device.allocate(n)},
                       ends = SharedBuffer{device.allocate(n * sizeof(glm::uvec2))};
    const auto run = [=, &stages] {
        stages.contour({.contours = {.corners = corner_table.get(),
                                     .edges = edge_table.get(),
                                     .faces = face_table.get(),
                                     .edge_count = n,
                                     .face_count = n,
                                     .replaced = 0,
                                     .vertex_count = n},
                        .triangles = *triangles,
                        .eye = {0, 0, 1, 0},
                        .front = *front,
                        .vertices = *places,
                        .crossed = *crossed,
                        .ends = *ends});
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = 124.0 * n, .result = [&device, ends, n] {
                return read_back<std::uint8_t>(device, *ends, n * sizeof(glm::uvec2));
            }};
}

} // namespace

Rows contour_rows(const Devices& devices) {
    return own_rows(devices, "contour", prepare_contour);
}

} // namespace lineatlas::bench
