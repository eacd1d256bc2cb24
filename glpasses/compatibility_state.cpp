#include "compatibility_state.hpp"

#include <iterator>

#include "lineatlas/error.hpp"

namespace lineatlas::gl {
namespace {

/// Capabilities that are off initially.
constexpr GLenum capabilities[] = {GL_ALPHA_TEST, GL_LINE_STIPPLE, GL_POLYGON_STIPPLE};

struct PixelTransfer {
    GLenum name;
    GLfloat initial;
};

constexpr PixelTransfer transfers[] = {
    {GL_RED_SCALE, 1},   {GL_GREEN_SCALE, 1}, {GL_BLUE_SCALE, 1}, {GL_ALPHA_SCALE, 1},
    {GL_RED_BIAS, 0},    {GL_GREEN_BIAS, 0},  {GL_BLUE_BIAS, 0},  {GL_ALPHA_BIAS, 0},
    {GL_DEPTH_SCALE, 1}, {GL_DEPTH_BIAS, 0},  {GL_MAP_COLOR, 0},
};

constexpr GLenum initial_clamp = GL_FIXED_ONLY;

GLint get(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

void check_drawing() {
    if (get(GL_LIST_INDEX) != 0) {
        throw UsageError("renderer: a display list is being compiled, which would take the calls "
                         "in place of the context; call it outside of glNewList() and glEndList()");
    }
    if (get(GL_RENDER_MODE) != GL_RENDER) {
        throw UsageError("renderer: nothing is drawn in selection or feedback mode; set "
                         "glRenderMode(GL_RENDER) first");
    }
}

} // namespace

bool is_compatibility() {
    return (get(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) == 0 &&
           (get(GL_CONTEXT_FLAGS) & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) == 0;
}

void CompatibilityState::save() {
    static_assert(std::size(capabilities) == capability_count);
    static_assert(std::size(transfers) == transfer_count);
    check_drawing();
    for (std::size_t i = 0; i < enabled_.size(); ++i) enabled_[i] = glIsEnabled(capabilities[i]);
    for (std::size_t i = 0; i < transfers_.size(); ++i)
        glGetFloatv(transfers[i].name, &transfers_[i]);
    clamp_ = get(GL_CLAMP_FRAGMENT_COLOR);
}

void CompatibilityState::set_initial() const {
    for (std::size_t i = 0; i < enabled_.size(); ++i)
        if (enabled_[i] != GL_FALSE) glDisable(capabilities[i]);
    for (std::size_t i = 0; i < transfers_.size(); ++i) {
        const auto& [name, initial] = transfers[i];
        if (transfers_[i] != initial) glPixelTransferf(name, initial);
    }
    if (static_cast<GLenum>(clamp_) != initial_clamp)
        glClampColor(GL_CLAMP_FRAGMENT_COLOR, initial_clamp);
}

void CompatibilityState::restore() const {
    for (std::size_t i = 0; i < enabled_.size(); ++i)
        if (enabled_[i] != GL_FALSE) glEnable(capabilities[i]);
    for (std::size_t i = 0; i < transfers_.size(); ++i) {
        const auto& [name, initial] = transfers[i];
        if (transfers_[i] != initial) glPixelTransferf(name, transfers_[i]);
    }
    if (static_cast<GLenum>(clamp_) != initial_clamp)
        glClampColor(GL_CLAMP_FRAGMENT_COLOR, static_cast<GLenum>(clamp_));
}

} // namespace lineatlas::gl
