#pragma once

#include <memory>
#include <optional>

#include <glm/vec2.hpp>

#include "core/surface_view.hpp"
#include "frame.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/handover.hpp"

namespace lineatlas {

/// What probes know of the surfaces in a frame's depth buffer: which triangle each texel shows,
/// where its plane lies, and of which smooth patch it is. Of a program's own depth nothing.
class SurfaceStage {
  public:
    explicit SurfaceStage(const interop::Connection& connection);

    /// For another line set.
    void set_scene() { planes_.reset(); }
    /// Before the depth of a frame, or of a tile of it, is drawn; size: texels of the depth buffer.
    void begin(Frame& frame, glm::ivec2 size);
    bool known() const { return known_; }
    /// What `depth` writes to by kernels, and GL's passes by a copy; null if nobody asks.
    interop::SharedBuffer* numbers() const { return numbered_ ? numbers_.get() : nullptr; }
    /// Computes the planes; seen: DepthArgs::seen, null for all clusters.
    void find_planes(Frame& frame, compute::Buffer* seen);

    /// Hands all that kernels wrote to GL, or takes it back.
    void to_gl();
    void to_compute();
    /// Where GL writes the numbers: takes them, and hands on what is new.
    void numbers_to_gl();
    void numbers_to_compute();

    /// While compute has it.
    std::optional<compute::SurfaceTables> tables(Frame& frame) const;
    /// While GL has it; numbers: a texture of them.
    gl::SurfaceTextures textures(Frame& frame, GLuint numbers);

  private:
    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    interop::SharingMode mode_;
    interop::Handover handover_;
    bool numbered_ = false; ///< the current frame's texels
    bool known_ = false;    ///< of the current frame, for probes
    SurfaceView view_{};
    std::size_t texels_ = 0; ///< of the current depth buffer
    std::unique_ptr<interop::SharedBuffer> numbers_, planes_;
    gl::TextureBuffer plane_texture_, patch_texture_;
};

} // namespace lineatlas
