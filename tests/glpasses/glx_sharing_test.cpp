// The context of an X window, whose properties are those of GLX. Needs a display (xvfb-run gives
// one).

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "gl_sharing_support.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/gl_context.hpp"

// Declared here as in GLFW/glfw3native.h, because that needs many headers of X.
extern "C" {
void* glfwGetX11Display();
void* glfwGetGLXContext(GLFWwindow* window);
}

namespace lineatlas::test {
namespace {

/// A hidden window and its context.
class GlxSharing : public UsesLayer {
  protected:
    void SetUp() override {
        if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "DISPLAY names no X display";
        ASSERT_EQ(glfwInit(), GLFW_TRUE);
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_NATIVE_CONTEXT_API);
        window_ = glfwCreateWindow(64, 64, "test", nullptr, nullptr);
        ASSERT_NE(window_, nullptr);
        glfwMakeContextCurrent(window_);
    }
    void TearDown() override { glfwTerminate(); }

    GLFWwindow* window_ = nullptr;
};

TEST_F(GlxSharing, PropertiesAreThoseOfTheWindow) {
    const auto property = [](void* value) {
        return reinterpret_cast<cl_context_properties>(value);
    };
    EXPECT_EQ(
        interop::current_gl_properties(),
        (std::vector<cl_context_properties>{CL_GL_CONTEXT_KHR, property(glfwGetGLXContext(window_)),
                                            CL_GLX_DISPLAY_KHR, property(glfwGetX11Display())}));
    glfwMakeContextCurrent(nullptr);
    EXPECT_TRUE(interop::current_gl_properties().empty());
}

TEST_F(GlxSharing, AnEglContextOfTheSameProcessIsTakenWhereItIsCurrent) {
    glfwMakeContextCurrent(nullptr);
    const gl::HeadlessContext egl;
    const std::vector<cl_context_properties> properties = interop::current_gl_properties();
    ASSERT_EQ(properties.size(), 4U);
    EXPECT_EQ(properties[2], CL_EGL_DISPLAY_KHR);
}

/// The layer refuses the properties of every context but the current one.
TEST_F(GlxSharing, SharesBuffersAndTextures) {
    for (const char* behaviour : {"", "events"}) {
        behave(behaviour);
        take_counts();
        const interop::ModeReport report =
            interop::probe_mode(device(), interop::SharingMode::gl_sharing);
        EXPECT_TRUE(report.works) << report.reason;
        const LayerCounts counts = take_counts();
        EXPECT_NE(report.reason.find(said_of_textures(counts)), std::string::npos) << report.reason;
        EXPECT_GT(counts.contexts, 0U);
        EXPECT_EQ(counts.violations, 0U);
    }
}

} // namespace
} // namespace lineatlas::test
