// facing: n triangles of a terrain.
// Bytes: per triangle its 3 indices (12) and the result (1), and every vertex (12) once.

#include "terrain.hpp"

namespace lineatlas::bench {
namespace {

Job prepare(compute::Backend& backend, std::uint32_t n) {
    const Terrain terrain = make_terrain(n, 0);
    const SharedBuffer vertices = to_device(backend, terrain.vertices);
    const SharedBuffer triangles = to_device(backend, terrain.triangles);
    const SharedBuffer none = backend.allocate(sizeof(Segment));
    const SharedBuffer front = backend.allocate(n);
    const auto run = [&backend, vertices, triangles, none, front, n, eye = terrain.eye] {
        backend.facing(
            {.table = {*vertices, *triangles, *none, n, 0}, .eye = eye, .front = *front});
        backend.finish();
    };
    run();
    return {.run = run, .bytes = 13.0 * n + 12.0 * terrain.vertex_count};
}

} // namespace

Rows facing_rows(const Backends& backends) {
    return own_rows(backends, "facing", prepare);
}

} // namespace lineatlas::bench
