#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/tiles.hpp"
#include "lineatlas/style.hpp"
#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// A pen's mark as a texture: coverage, u along the stroke and v across it.
struct PenTexture {
    GLuint texture = 0;      ///< 0: a solid mark
    float repeat_length = 1; ///< pixels on the screen that one repeat of the texture covers

    /// Binds the texture to `unit` and sets the uniforms of mark.glsl.
    void bind(const Program& program, GLuint unit) const;
};

struct StrokeParams {
    glm::vec2 viewport; ///< pixels
    PictureTile tile;   ///< the part of it that is drawn
    glm::ivec2 origin;  ///< where in the framebuffer that part begins
    float width;        ///< pixels
    glm::vec4 color;    ///< RGB and opacity
    PenTexture pen;

    /// Prepares GL for strokes over the bound framebuffer, with the pen on texture `unit`, and sets
    /// the uniforms that all stroke shaders have. Blending stays on.
    void bind(const Program& program, GLuint unit) const;
};

/// Line density on the GL side, as `density` writes it.
struct DensityWeights {
    GLuint buffer = 0; ///< floats, LA_DENSITY_BINS planes of `cells`; 0: all lines are drawn
    glm::ivec2 cells{0, 0};
    float cell = 0; ///< pixels per axis
};

/// What the shader has to know about a focus (Focus in style.hpp).
struct FocusParams {
    bool in_scene = false;
    glm::vec3 point{0, 0, 0};      ///< pixels, or in the model's coordinates
    float radius = 0, falloff = 0; ///< in the same units
    float far_width = 1;           ///< factors far from the focus
    float far_opacity = 1;
    PenTexture far_pen; ///< the mark far from the focus
    glm::mat4 world_from_clip{1};
};

/// How strokes are drawn beyond the basics.
struct StrokeStyle {
    Join join = Join::mitre;
    float mitre_limit = 4;
    Cap cap = Cap::butt, path_cap = Cap::round;
    float cap_length = 12;
    std::span<const float> width_profile, opacity_profile; ///< at least one value each
    PenTexture cap_grain;                                  ///< for textured caps
    std::optional<FocusParams> focus;
    bool hidden = false; ///< draw runs of hidden samples, opaque where the line is hidden
    std::optional<std::uint32_t> only_pen{}; ///< draw only the runs of this pen; none: all runs
    /// Runs end exactly where visibility does (`filter`); some have no samples.
    bool exact_ends = false;
};

/// The visible runs on the GL side, as `compact` writes them.
struct RunBuffers {
    GLuint runs;   ///< `Run` each
    GLuint record; ///< `FrameRecord`, source of the indirect draw
    GLuint alpha;  ///< the segment atlas, one byte per texel
};

/// `strokes`: draws the visible runs over the bound framebuffer, premultiplied. The draw is
/// indirect, so the number of runs stays on the device.
class StrokePass {
  public:
    StrokePass();
    void draw(const RunBuffers& runs, const StrokeParams& params, const StrokeStyle& style,
              const DensityWeights& density = {});

  private:
    ProgramVariants programs_;
    VertexArray array_;
    TextureBuffer alpha_, weights_; ///< views of the buffers of a draw
    std::string features_;          ///< kept for its memory
};

} // namespace lineatlas::gl
