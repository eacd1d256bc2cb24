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
    /// Call before the depth of a frame, or of a tile of it, is drawn. size: texels of the depth
    /// buffer.
    void begin(Frame& frame, glm::ivec2 size);
    bool known() const { return known_; }
    /// The numbers of triangles, which kernels of `depth` write and GL passes copy; null if nobody
    /// asks for them.
    interop::SharedTable* numbers() { return numbered_ ? &numbers_ : nullptr; }
    /// Computes the planes. seen: DepthArgs::seen; null: of all clusters.
    void find_planes(Frame& frame, compute::Buffer* seen);

    /// The surfaces for kernels.
    std::optional<compute::SurfaceTables> tables(Frame& frame);
    /// The surfaces for GL. numbers: the texture with the numbers of triangles.
    gl::SurfaceTextures textures(Frame& frame, GLuint numbers);

  private:
    compute::Stages& stages_;
    bool numbered_ = false; ///< the current frame's texels have numbers
    bool known_ = false;    ///< probes of the current frame know surfaces
    SurfaceView view_{};
    interop::SharedTable numbers_, planes_;
    gl::TextureBuffer plane_texture_, patch_texture_;
};

} // namespace lineatlas
