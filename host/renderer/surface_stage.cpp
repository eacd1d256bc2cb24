#include "surface_stage.hpp"

#include <algorithm>

#include "glpasses/storage.hpp"

namespace lineatlas {

SurfaceStage::SurfaceStage(const interop::Connection& connection)
    : stages_(*connection.stages), numbers_(*connection.sharing, compute::table::seen_numbers),
      planes_(*connection.sharing, compute::table::planes),
      plane_texture_(gl::TextureBuffer::create()), patch_texture_(gl::TextureBuffer::create()) {}

void SurfaceStage::begin(Frame& frame, glm::ivec2 size) {
    known_ = frame.knows_surfaces();
    numbered_ = frame.numbers_surfaces();
    if (!numbered_) return;
    view_ = surface_view(frame.camera);
    numbers_.fit(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                 sizeof(la_uint));
    if (known_) planes_.fit(std::max(frame.scene.triangle_count(), 1U) * sizeof(glm::vec4));
}

void SurfaceStage::find_planes(Frame& frame, compute::Buffer* seen) {
    if (!known_) return;
    frame.clock("planes", [&] {
        const compute::MeshletTables model = frame.scene.meshlets();
        stages_.launch<compute::kernels::planes>(
            model.count,
            {.count = model.count,
             .world_from_screen = view_.world_from_screen,
             .contact = frame.scene.contact(),
             .only_seen = seen != nullptr ? 1U : 0U},
            {.vertices = &frame.scene.table().vertices, .seen = seen, .planes = &planes_.compute()},
            model);
    });
}

std::optional<compute::SurfaceTables> SurfaceStage::tables(Frame& frame) {
    if (!known_) return std::nullopt;
    return compute::SurfaceTables{.numbers = numbers_.compute(),
                                  .planes = planes_.compute(),
                                  .patches = frame.scene.surfaces().patches,
                                  .parallel = view_.parallel,
                                  .bend = view_.bend};
}

gl::SurfaceTextures SurfaceStage::textures(Frame& frame, GLuint numbers) {
    if (!known_) return {};
    gl::check_buffer_texture(frame.scene.triangle_count(), purpose::depth);
    glTextureBuffer(plane_texture_.id(), GL_RGBA32F, planes_.gl());
    glTextureBuffer(patch_texture_.id(), GL_R32UI, frame.scene.gl_surfaces().patches);
    return {.numbers = numbers,
            .planes = plane_texture_.id(),
            .patches = patch_texture_.id(),
            .parallel = view_.parallel,
            .bend = view_.bend};
}

} // namespace lineatlas
