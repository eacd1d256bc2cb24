// depth: n triangles of a terrain that is wholly in view, at 2048x1536 texels. The way `gl` is GL
// on this machine: it draws all triangles into a texture and copies the texture into a buffer.
// Bytes: per triangle three corners (36), per texel the depth (4). depth_numbers also writes the
// number of the triangle that each texel shows, 4 more bytes per texel.

#include "glpasses/depth_pass.hpp"
#include "glpasses/headless_context.hpp"
#include "terrain_meshlets.hpp"

namespace lineatlas::bench {
namespace {

constexpr glm::ivec2 size{2048, 1536};
constexpr std::size_t texels = 2048U * 1536U;

double bytes_of(std::uint32_t n) {
    return 36.0 * n + 4.0 * static_cast<double>(texels);
}

template <bool numbered>
Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const TerrainMeshlets model{device, make_terrain_mesh(n)};
    const glm::ivec2 tile_count = compute::tiles_for(size);
    const SharedBuffer depth = device.allocate(texels * sizeof(float));
    const SharedBuffer numbers = device.allocate(numbered ? texels * sizeof(std::uint32_t) : 4);
    const SharedBuffer tiles =
        device.allocate(static_cast<std::size_t>(tile_count.x) *
                        static_cast<std::size_t>(tile_count.y) * sizeof(float));
    const SharedBuffer seen = device.allocate(model.count * sizeof(std::uint32_t));
    const auto run = [=, &stages] {
        stages.depth({.model = model.tables(),
                      .vertices = *model.vertices,
                      .clip_from_world = model.clip_from_world,
                      .whole_size = size,
                      .origin = {0, 0},
                      .size = size,
                      .covered = {{0, 0}, size},
                      .tiles = *tiles,
                      .seen = *seen,
                      .depth = depth.get(),
                      .numbers = numbered ? numbers.get() : nullptr});
        stages.device().finish();
    };
    run();
    const double bytes = bytes_of(n) + (numbered ? 4.0 * static_cast<double>(texels) : 0);
    return {.run = run, .bytes = bytes, .result = [&device, depth] {
                return read_back<float>(device, *depth, texels);
            }};
}

/// The mesh in GL. The context comes first, because it must end last.
struct OnGl {
    std::unique_ptr<gl::HeadlessContext> context = std::make_unique<gl::HeadlessContext>();
    gl::DepthPass pass{};
    gl::Buffer vertices = gl::Buffer::create(), indices = gl::Buffer::create(),
               depth = gl::Buffer::create();
};

Job prepare_gl(std::uint32_t n) {
    const TerrainMesh mesh = make_terrain_mesh(n);
    const auto on = std::make_shared<OnGl>();
    const auto fill = [](const gl::Buffer& buffer, const auto& values) {
        const auto bytes = std::as_bytes(std::span{values});
        glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(bytes.size()), bytes.data(), 0);
    };
    fill(on->vertices, mesh.vertices);
    fill(on->indices, mesh.triangles);
    glNamedBufferStorage(on->depth.id(), texels * sizeof(float), nullptr, 0);
    const auto run = [on, n, clip_from_world = mesh.clip_from_world] {
        on->pass.begin(size, 1);
        on->pass.draw(
            {.vertices = on->vertices.id(), .indices = on->indices.id(), .triangle_count = n},
            clip_from_world);
        on->pass.copy_to(on->depth.id(), {{0, 0}, size});
        glFinish();
    };
    run();
    return {.run = run, .bytes = bytes_of(n)};
}

} // namespace

Rows depth_rows(const Devices& devices) {
    Rows rows = own_rows(devices, "depth", prepare<false>);
    for (Row& row : own_rows(devices, "depth_numbers", prepare<true>))
        rows.push_back(std::move(row));
    rows.push_back({"depth/gl", prepare_gl});
    rows.push_back(copy_row(devices, "depth", bytes_of));
    return rows;
}

} // namespace lineatlas::bench
