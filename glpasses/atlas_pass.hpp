#pragma once

#include <cstdint>
#include <string_view>

#include <glm/vec2.hpp>

#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// The surfaces in a depth texture, for probes that know surfaces (kernels/shared/spine.h).
struct SurfaceTextures {
    GLuint numbers = 0; ///< numbers of the triangles that texels show; 0: only depth is known
    GLuint planes = 0;  ///< a texture over a buffer of 4 floats per triangle
    GLuint patches = 0; ///< a texture over a buffer of a uint32 per triangle
    bool parallel = false;
    float bend = 0; ///< nearness by which a line's own patch may stand before it, times w
};

/// How visibility is probed; the same for both forms of `atlas`.
struct ProbeParams {
    GLuint depth;         ///< depth texture; not read if surfaces are known
    glm::vec2 viewport;   ///< pixels
    float depth_scale;    ///< depth texels per pixel
    std::uint32_t probes; ///< per axis
    float tolerance;      ///< window depth that may stand before a line, times w
    SurfaceTextures surfaces{};

    /// Binds the depth texture to `unit` and the textures of surfaces to units of their own, and
    /// sets the uniforms of probe.glsl.
    void bind(const Program& program, GLuint unit) const;
};

/// The clipped segment table on the GL side.
struct ClippedBuffers {
    GLuint clipped; ///< `ClippedSegment` each
    GLuint offsets; ///< segment_count + 1 uint32
    std::uint32_t segment_count;
};

/// Texels of a row of the raster atlas for segments of up to `longest` samples; no row is longer
/// than `most`. Throws UsageError if such a segment doesn't fit: the sample step is too fine for
/// the picture size.
std::uint32_t atlas_row(std::uint32_t longest, std::uint32_t most);

/// `atlas`, raster form: proxy lines into a 2D texture (§4.2). A segment that is longer than the
/// rest of its row goes on in the next row, so rows are full and sample s is texel s. Lines are
/// drawn twice for that (eq. 2, Fig. 8: "wrapped").
class AtlasPass {
  public:
    /// `fragment_shader`: finds the visibility of one sample. The caller sets its own uniforms in
    /// `program()`.
    explicit AtlasPass(std::string_view fragment_shader = "atlas.frag");
    const Program& program() const { return program_; }

    /// Draws an atlas of `samples` samples in rows of `row` texels and copies whole rows of it to
    /// `alpha`: one byte per texel.
    void draw(const ClippedBuffers& segments, const ProbeParams& probes, std::uint32_t row,
              std::uint32_t samples, GLuint alpha);

  private:
    void resize(glm::ivec2 size);

    Program program_;
    VertexArray vertex_array_;
    Framebuffer framebuffer_;
    Texture2D texture_;
    glm::ivec2 size_{0, 0};
};

} // namespace lineatlas::gl
