// project_clip: n segments of a terrain, all of them in view.
// Bytes: per segment the segment (32), the two results (8) and, where it has samples, the clipped
// segment (48); every triangle (12) and vertex (12) once.
//
// project_clip_batches: the batches outside the picture. Bytes: per batch its box and a byte.

#include <algorithm>
#include <iterator>
#include <memory>

#include <glm/matrix.hpp>

#include "compute/stages/batches.hpp"
#include "terrain.hpp"

namespace lineatlas::bench {
namespace {

struct Projection {
    Projection(compute::Stages& stages, std::uint32_t n)
        : device(stages.device()), terrain(make_terrain(n, n)),
          triangle_count(static_cast<std::uint32_t>(terrain.triangles.size() / 3)), count(n),
          batches(stages) {}

    compute::SegmentTable table() const {
        return {*vertices, *triangles, *segments, triangle_count, count};
    }
    compute::ProjectClipArgs args() const {
        return {.table = table(),
                .front = *front,
                .clip_from_world = terrain.clip_from_world,
                .viewport = {1024, 768},
                .step = 2,
                .kind_mask = (1U << LA_KIND_COUNT) - 1,
                .occlusion = nullptr,
                .out = {*clipped, *counts, *arcs}};
    }

    compute::Device& device;
    Terrain terrain;
    std::uint32_t triangle_count, count;
    SharedBuffer vertices = to_device(device, terrain.vertices);
    SharedBuffer triangles = to_device(device, terrain.triangles);
    SharedBuffer segments = to_device(device, terrain.segments);
    SharedBuffer front = to_device(device, std::vector<std::uint8_t>(triangle_count));
    SharedBuffer clipped = device.allocate(count * sizeof(ClippedSegment));
    SharedBuffer counts = device.allocate((count + std::size_t{1}) * sizeof(std::uint32_t));
    SharedBuffer arcs = device.allocate((count + std::size_t{1}) * sizeof(std::uint32_t));
    compute::Batches batches;
};

Job prepare(compute::Stages& stages, std::uint32_t n) {
    const auto made = std::make_shared<Projection>(stages, n);
    const auto run = [=, &stages] {
        stages.project_clip(made->args());
        stages.device().finish();
    };
    run();
    double bytes = 40.0 * n + 12.0 * made->triangle_count + 12.0 * made->terrain.vertex_count;
    for (const std::uint32_t count : read_back<std::uint32_t>(made->device, *made->counts, n)) {
        if (count != 0) bytes += 48;
    }
    return {.run = run, .bytes = bytes, .result = [=] {
                return read_back<std::uint8_t>(made->device, *made->counts,
                                               made->count * sizeof(std::uint32_t));
            }};
}

Job prepare_batches(compute::Stages& stages, std::uint32_t n) {
    const auto made = std::make_shared<Projection>(stages, n);
    made->batches.has_segments(made->table());
    require(made->batches.has_segments(made->table()),
            "project_clip_boxes"); // the second frame without motion makes the boxes
    const auto count = (std::size_t{n} + LA_BATCH - 1) / LA_BATCH;
    const auto run = [=, &stages] {
        compute::ProjectClipArgs args = made->args();
        args.batches = made->batches.table();
        stages.project_clip_batches(args, false);
        stages.device().finish();
    };
    run();
    return {.run = run,
            .bytes = static_cast<double>(count) * (sizeof(compute::Batch) + 1),
            .result = [=] {
                return read_back<std::uint8_t>(made->device, *made->batches.table().states, count);
            }};
}

} // namespace

Rows project_clip_rows(const Devices& devices) {
    Rows rows = own_rows(devices, "project_clip", prepare);
    std::ranges::move(own_rows(devices, "project_clip_batches", prepare_batches),
                      std::back_inserter(rows));
    return rows;
}

} // namespace lineatlas::bench
