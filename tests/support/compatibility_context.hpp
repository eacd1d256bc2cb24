#pragma once

#include <array>

#include <epoxy/egl.h>
#include <gtest/gtest.h>

#include "glpasses/headless_context.hpp"

namespace lineatlas::test {

/// A context of the compatibility profile: the one that programs get if they ask for no profile.
/// The context is current from its construction to its destruction.
class CompatibilityContext {
  public:
    CompatibilityContext() {
        const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                               4,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               5,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                               EGL_NONE};
        context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
        EXPECT_NE(context_, EGL_NO_CONTEXT) << "no driver here has a compatibility profile";
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
    }
    ~CompatibilityContext() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
    CompatibilityContext(const CompatibilityContext&) = delete;
    CompatibilityContext& operator=(const CompatibilityContext&) = delete;

  private:
    gl::HeadlessContext core_; ///< opens the display
    EGLDisplay display_ = eglGetCurrentDisplay();
    EGLContext context_ = EGL_NO_CONTEXT;
};

} // namespace lineatlas::test
