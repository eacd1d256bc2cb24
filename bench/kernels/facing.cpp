// facing: n triangles of a terrain.
// Bytes: per triangle its three indices (12) and the result (1), every vertex (12) once.

#include "terrain.hpp"

namespace lineatlas::bench {
namespace {

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Terrain terrain = make_terrain(n, 0);
    const SharedBuffer vertices = to_device(device, terrain.vertices);
    const SharedBuffer triangles = to_device(device, terrain.triangles);
    const SharedBuffer none = device.allocate(sizeof(Segment));
    const SharedBuffer front = device.allocate(n);
    const auto run = [&stages, vertices, triangles, none, front, n, eye = terrain.eye] {
        stages.facing({*vertices, *triangles, *none, n, 0}, eye, *front);
        stages.device().finish();
    };
    run();
    return {.run = run,
            .bytes = 13.0 * n + 12.0 * terrain.vertex_count,
            .result = [&device, front, n] { return read_back<std::uint8_t>(device, *front, n); }};
}

} // namespace

Rows facing_rows(const Devices& devices) {
    return own_rows(devices, "facing", prepare);
}

} // namespace lineatlas::bench
