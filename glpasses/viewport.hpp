#pragma once

#include <epoxy/gl.h>
#include <glm/vec2.hpp>

namespace lineatlas::gl {

/// Sets the first of GL's viewports. The program around may use the others.
inline void set_viewport(glm::ivec2 low, glm::ivec2 size) {
    glViewportIndexedf(0, static_cast<float>(low.x), static_cast<float>(low.y),
                       static_cast<float>(size.x), static_cast<float>(size.y));
}

/// Clears the depth of a part of the bound framebuffer.
inline void clear_depth(glm::ivec2 low, glm::ivec2 size) {
    const float far = 1.0F;
    glScissorIndexed(0, low.x, low.y, size.x, size.y);
    glEnablei(GL_SCISSOR_TEST, 0);
    glClearBufferfv(GL_DEPTH, 0, &far);
    glDisablei(GL_SCISSOR_TEST, 0);
}

} // namespace lineatlas::gl
