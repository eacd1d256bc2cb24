// project_clip: n segments of a terrain, all of them in view.
// Bytes: per segment the segment (32), the two results (8) and, where it has samples, the clipped
// segment (48); every triangle (12) and vertex (12) once.

#include <glm/matrix.hpp>

#include "terrain.hpp"

namespace lineatlas::bench {
namespace {

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Terrain terrain = make_terrain(n, n);
    const auto triangle_count = static_cast<std::uint32_t>(terrain.triangles.size() / 3);
    const SharedBuffer vertices = to_device(device, terrain.vertices);
    const SharedBuffer triangles = to_device(device, terrain.triangles);
    const SharedBuffer segments = to_device(device, terrain.segments);
    const SharedBuffer front = to_device(device, std::vector<std::uint8_t>(triangle_count));
    const SharedBuffer clipped = device.allocate(n * sizeof(ClippedSegment));
    const SharedBuffer counts = device.allocate((n + std::size_t{1}) * sizeof(std::uint32_t));
    const SharedBuffer arcs = device.allocate((n + std::size_t{1}) * sizeof(std::uint32_t));
    const glm::mat4 clip_from_world = terrain.clip_from_world;
    const glm::mat4 world_from_clip{glm::inverse(glm::dmat4{clip_from_world})};
    const auto run = [=, &stages] {
        stages.project_clip({.table = {*vertices, *triangles, *segments, triangle_count, n},
                             .front = *front,
                             .clip_from_world = clip_from_world,
                             .world_from_clip = world_from_clip,
                             .viewport = {1024, 768},
                             .step = 2,
                             .kind_mask = (1U << LA_KIND_COUNT) - 1,
                             .occlusion = nullptr,
                             .out = {*clipped, *counts, *arcs}});
        stages.device().finish();
    };
    run();
    double bytes = 40.0 * n + 12.0 * triangle_count + 12.0 * terrain.vertex_count;
    for (const std::uint32_t count : read_back<std::uint32_t>(device, *counts, n)) {
        if (count != 0) bytes += 48;
    }
    return {.run = run, .bytes = bytes, .result = [&device, counts, n] {
                return read_back<std::uint8_t>(device, *counts, n * sizeof(std::uint32_t));
            }};
}

} // namespace

Rows project_clip_rows(const Devices& devices) {
    return own_rows(devices, "project_clip", prepare);
}

} // namespace lineatlas::bench
