#pragma once

#include <epoxy/gl.h>
#include <glm/vec2.hpp>

#include "core/limits.hpp"
#include "core/line_pens.hpp"
#include "core/standard_camera.hpp"
#include "core/tiles.hpp"
#include "form_costs.hpp"
#include "glpasses/atlas_pass.hpp"
#include "glpasses/stroke_pass.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/renderer.hpp"
#include "pen_textures.hpp"
#include "scene_buffers.hpp"
#include "stage_clock.hpp"

namespace lineatlas {

class Backdrop;

/// What a method needs to draw one frame.
struct Frame {
    const Camera& camera;         ///< a standard camera
    DepthMapping depth_mapping{}; ///< of the program's own depth, if there is one
    const FrameOptions& options;
    AutomaticForms automatic{}; ///< of stages whose form `options` leave open
    SceneBuffers& scene;
    GLuint framebuffer;
    PenTextures& pens;
    Backdrop& backdrop;
    StageClock clock;
    PictureTile tile{{0, 0}, camera.size}; ///< the part of the picture that goes there

    glm::vec2 viewport() const { return glm::vec2{camera.size}; }
    glm::mat4 clip_of_tile() const {
        return tile_projection(camera.clip_from_world(), tile, camera.size);
    }
    /// The kinds of line that are drawn.
    LineKindMask kinds() const { return drawn_kinds(options.lines, options.style); }
    /// Depth texels per pixel and axis.
    int depth_scale() const {
        return options.own_depth ? options.own_depth->scale : options.depth_scale;
    }
    /// Probes per axis of the box of probes.
    std::uint32_t probes_per_axis() const;
    /// Window depth that may stand before a line, times w (kernels/atlas.cl).
    float depth_tolerance() const;
    /// Whether probes judge the surfaces that they hit, and not depth alone. They do unless the
    /// depth is the program's own, whose surfaces are not known.
    bool knows_surfaces() const;
    /// Whether each texel of the depth gets the number of its triangle, for probes or for a fill.
    /// The exact method has depth only for fills.
    bool numbers_surfaces() const { return knows_surfaces() || options.method == Method::exact; }
    /// Whether segments and triangles that are hidden as a whole are looked for and left out.
    bool culls_hidden() const;
    /// Pens and visibility as the passes take them.
    gl::StrokeParams stroke_params(const Pen& pen) const;
    gl::ProbeParams probe_params(GLuint depth) const;
};

/// Probes per axis: the root of `probes`, which is a square number.
std::uint32_t probes_per_axis(std::uint32_t probes);

/// Throws UsageError if the device has no textures as large as a depth buffer of that size.
void check_depth_size(glm::ivec2 size);

/// Whether the framebuffer has depth, so that a depth test works.
bool has_depth_attachment(GLuint framebuffer);

/// Whether the picture has 8 bits per channel, as coverage has.
bool has_bytes(GLuint framebuffer);

} // namespace lineatlas
