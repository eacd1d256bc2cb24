// planes: n triangles of a terrain.
// Bytes: per triangle its corners (3) and its plane (16), every vertex (12) once.

#include <algorithm>
#include <cmath>

#include "core/surface_view.hpp"
#include "terrain_meshlets.hpp"

namespace lineatlas::bench {
namespace {

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const TerrainMeshlets model{device, make_terrain_mesh(n)};
    const SharedBuffer planes = device.allocate(n * 4 * sizeof(float));
    const SurfaceView view = surface_view(
        {.view = glm::mat4{1}, .projection = model.clip_from_world, .size = {1024, 768}});
    const auto run = [=, &stages] {
        const compute::MeshletTables tables = model.tables();
        stages.launch<compute::kernels::planes>(
            tables.count,
            {.count = tables.count,
             .world_from_screen = view.world_from_screen,
             .contact = 1e-6F,
             .only_seen = 0},
            {.vertices = model.vertices.get(), .seen = nullptr, .planes = planes.get()}, tables);
        stages.device().finish();
    };
    run();
    const auto result = [&device, planes, n] {
        return read_back<float>(device, *planes, 4 * std::size_t{n});
    };
    // The tolerance of planes seen edge-on is infinite, which is no error.
    require(std::ranges::none_of(result(), [](float x) { return std::isnan(x); }), "planes");
    const double vertices = static_cast<double>(model.vertices->size());
    return {.run = run, .bytes = 19.0 * n + vertices, .result = result};
}

} // namespace

Rows planes_rows(const Devices& devices) {
    return own_rows(devices, "planes", prepare);
}

} // namespace lineatlas::bench
