#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "core/surface_view.hpp"
#include "frame.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/shared_table.hpp"

namespace lineatlas {

/// The surfaces in a frame's depth buffer, for probes: which triangle each texel shows, its plane,
/// and its smooth patch. For a program's own depth none of this is known.
class SurfaceStage {
  public:
    explicit SurfaceStage(const interop::Connection& connection);

    /// For another line set.
    void set_scene() { planes_.release(); }
    /// Before the depth of a frame, or of a tile of it, is drawn; size: texels of the depth buffer.
    void begin(Frame& frame, glm::ivec2 size);
    bool known() const { return known_; }
    /// What `depth` writes to by kernels, and GL's passes by a copy; null if nobody asks.
    interop::SharedTable* numbers() { return numbered_ ? &numbers_ : nullptr; }
    /// Computes the planes; seen: DepthArgs::seen, null for all clusters.
    void find_planes(Frame& frame, compute::Buffer* seen);

    /// For kernels.
    std::optional<compute::SurfaceTables> tables(Frame& frame);
    /// For GL; numbers: a texture of them.
    gl::SurfaceTextures textures(Frame& frame, GLuint numbers);

  private:
    compute::Stages& stages_;
    bool numbered_ = false; ///< the current frame's texels
    bool known_ = false;    ///< of the current frame, for probes
    SurfaceView view_{};
    interop::SharedTable numbers_, planes_;
    gl::TextureBuffer plane_texture_, patch_texture_;
};

} // namespace lineatlas
