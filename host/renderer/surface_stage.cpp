#include "surface_stage.hpp"

#include <algorithm>

#include "glpasses/storage.hpp"

namespace lineatlas {
namespace {

constexpr std::size_t plane_bytes = 4 * sizeof(float);

} // namespace

SurfaceStage::SurfaceStage(const interop::Connection& connection)
    : stages_(*connection.stages), device_(stages_.device()), mode_(connection.mode),
      handover_(device_), plane_texture_(gl::TextureBuffer::create()),
      patch_texture_(gl::TextureBuffer::create()) {}

void SurfaceStage::begin(Frame& frame, glm::ivec2 size) {
    known_ = frame.knows_surfaces();
    numbered_ = frame.numbers_surfaces();
    if (!numbered_) return;
    view_ = surface_view(frame.camera);
    texels_ = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    const std::size_t bytes = texels_ * sizeof(la_uint);
    if (!numbers_ || numbers_->size() < bytes) {
        numbers_.reset(); // it may not fit beside another
        numbers_ = interop::make_shared_buffer(device_, mode_, bytes, purpose::depth);
    }
    if (known_ && !planes_) {
        const std::size_t count = std::max(frame.scene.triangle_count(), 1U);
        planes_ = interop::make_shared_buffer(device_, mode_, count * plane_bytes, purpose::model);
    }
}

void SurfaceStage::find_planes(Frame& frame, compute::Buffer* seen) {
    if (!known_) return;
    frame.clock.handover([&] { handover_.to_compute({planes_.get()}); });
    frame.clock("planes", [&] {
        stages_.planes({.model = frame.scene.meshlets(),
                        .vertices = frame.scene.table().vertices,
                        .view = view_,
                        .contact = frame.scene.contact(),
                        .seen = seen,
                        .planes = planes_->compute()});
    });
}

void SurfaceStage::to_gl() {
    if (!known_) return;
    numbers_->wrote(texels_ * sizeof(la_uint));
    planes_->wrote(planes_->size());
    handover_.to_gl({numbers_.get(), planes_.get()});
}

void SurfaceStage::to_compute() {
    if (!numbered_) return;
    handover_.to_compute({numbers_.get(), known_ ? planes_.get() : nullptr});
}

void SurfaceStage::numbers_to_gl() {
    if (known_) handover_.to_gl({numbers_.get()});
}

void SurfaceStage::numbers_to_compute() {
    if (!known_) return;
    numbers_->wrote(texels_ * sizeof(la_uint));
    handover_.to_compute({numbers_.get()});
}

std::optional<compute::SurfaceTables> SurfaceStage::tables(Frame& frame) const {
    if (!known_) return std::nullopt;
    return compute::SurfaceTables{.numbers = numbers_->compute(),
                                  .planes = planes_->compute(),
                                  .patches = frame.scene.surfaces().patches,
                                  .parallel = view_.parallel,
                                  .bend = view_.bend};
}

gl::SurfaceTextures SurfaceStage::textures(Frame& frame, GLuint numbers) {
    if (!known_) return {};
    gl::check_buffer_texture(frame.scene.triangle_count(), purpose::depth);
    glTextureBuffer(plane_texture_.id(), GL_RGBA32F, planes_->gl());
    glTextureBuffer(patch_texture_.id(), GL_R32UI, frame.scene.gl_surfaces().patches);
    return {.numbers = numbers,
            .planes = plane_texture_.id(),
            .patches = patch_texture_.id(),
            .parallel = view_.parallel,
            .bend = view_.bend};
}

} // namespace lineatlas
