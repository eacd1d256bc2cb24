#pragma once

#include <array>

#include <epoxy/gl.h>

#include "compatibility_state.hpp"

namespace lineatlas::gl {

/// Gives passes the GL state that they expect, and afterwards restores the state of the program
/// around them.
///
/// It saves the state that passes change or depend on. Passes use only the first viewport, the
/// first draw buffer and the first texture units, and reach objects by name. They do not touch any
/// other state (indexed buffers, images, pipelines, queries, debug groups).
class StateGuard {
  public:
    /// Saves the state of the current context and sets the state that passes expect: GL's initial
    /// state, except for bindings. Throws UsageError if no pass can run: while a transform feedback
    /// is active, and as CompatibilityState::save() does.
    StateGuard();
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

    /// For calls back into the program: restore() gives the program's state back, and take() saves
    /// it again.
    void restore();
    void take();

  private:
    static constexpr int texture_units = 9; ///< that passes use
    static constexpr int most_draw_buffers = 8;
    static constexpr int capability_count = 29;
    static constexpr int pixel_store_count = 16;

    struct TextureUnit {
        GLint texture_2d, texture_buffer, sampler;
    };

    void save();
    void set_initial();
    void save_raster();
    void restore_raster() const;
    void save_blend();
    void restore_blend() const;
    void save_textures();
    void restore_textures() const;

    bool is_compatibility_ = false;
    CompatibilityState compatibility_; ///< used if is_compatibility_
    std::array<GLboolean, capability_count> enabled_{};
    std::array<GLint, pixel_store_count> pixel_store_{};
    GLint program_ = 0, vertex_array_ = 0, draw_framebuffer_ = 0, read_framebuffer_ = 0;
    GLint pack_buffer_ = 0, unpack_buffer_ = 0, indirect_buffer_ = 0, query_buffer_ = 0;
    // Raster
    std::array<GLfloat, 4> viewport_{};
    std::array<GLint, 4> scissor_{};
    std::array<GLdouble, 2> depth_range_{};
    GLboolean scissor_test_ = GL_FALSE, depth_mask_ = GL_TRUE;
    GLint depth_func_ = 0, clip_origin_ = 0, clip_depth_ = 0, provoking_vertex_ = 0;
    std::array<GLint, 2> polygon_mode_{};
    GLfloat offset_factor_ = 0, offset_units_ = 0, offset_clamp_ = 0, line_width_ = 1;
    // Blending, of the first draw buffer; the others are masked.
    GLboolean blend_ = GL_FALSE;
    GLint source_rgb_ = 0, source_alpha_ = 0, target_rgb_ = 0, target_alpha_ = 0;
    GLint equation_rgb_ = 0, equation_alpha_ = 0;
    GLint draw_buffers_ = 1;
    std::array<std::array<GLboolean, 4>, most_draw_buffers> color_masks_{};

    GLint active_texture_ = 0;
    std::array<TextureUnit, texture_units> units_{};
};

} // namespace lineatlas::gl
