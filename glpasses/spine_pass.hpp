#pragma once

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "atlas_pass.hpp"
#include "objects.hpp"
#include "program.hpp"
#include "stroke_pass.hpp"

namespace lineatlas::gl {

/// The segment table on the GL side.
struct SegmentBuffers {
    GLuint segments;  ///< `Segment` each
    GLuint vertices;  ///< 3 floats each
    GLuint triangles; ///< 3 uint32 each
    GLuint numbers;   ///< a uint32 per triangle, as in SurfaceTextures; 0 if surfaces are not known
    std::uint32_t segment_count, vertex_count, triangle_count;
};

struct SpineParams {
    glm::mat4 clip_from_world;
    glm::mat4 world_from_clip;
    glm::vec4 eye;           ///< Camera::eye()
    std::uint32_t kind_mask; ///< kinds to draw, bit 1 << kind
    float step;              ///< length of the box of probes along the line, pixels
    GLuint tiles;            ///< the depth pyramid, a float per tile; 0: keep hidden segments
    glm::ivec2 tile_count;   ///< tiles per axis
};

/// `spine`: strokes straight from the segment table in one pass, with visibility tested in the
/// fragment shader at the nearest point of the spine (§3).
class SpinePass {
  public:
    SpinePass();
    /// Draws over the bound framebuffer, premultiplied.
    void draw(const SegmentBuffers& segments, const SpineParams& spine, const ProbeParams& probes,
              const StrokeParams& stroke);

  private:
    ProgramVariants programs_;
    VertexArray array_;
    TextureBuffer vertices_, triangles_, tiles_, numbers_; ///< views of the buffers of a draw
};

} // namespace lineatlas::gl
