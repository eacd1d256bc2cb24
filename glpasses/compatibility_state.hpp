#pragma once

#include <array>

#include <epoxy/gl.h>

namespace lineatlas::gl {

/// True if the current context has the functions that OpenGL 3.1 removed: the compatibility
/// profile.
bool is_compatibility();

/// State that only a compatibility context has and that changes pictures drawn by shaders:
/// operations on fragments, and on pixels on their way into textures and out of them.
class CompatibilityState {
  public:
    /// Throws UsageError if the context carries out no drawing: while a display list is compiled,
    /// and in selection or feedback mode.
    void save();
    /// Sets GL's initial state where the saved state differs from it.
    void set_initial() const;
    void restore() const;

  private:
    static constexpr int capability_count = 3;
    static constexpr int transfer_count = 11;

    std::array<GLboolean, capability_count> enabled_{};
    std::array<GLfloat, transfer_count> transfers_{};
    GLint clamp_ = 0;
};

} // namespace lineatlas::gl
