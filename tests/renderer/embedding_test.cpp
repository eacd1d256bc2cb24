// The renderer in programs that embed it: their depth, viewport, contexts and threads.

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <thread>
#include <type_traits>

#include <gtest/gtest.h>

#include <epoxy/egl.h>

#include "allocation_count.hpp"
#include "compare.hpp"
#include "compatibility_context.hpp"
#include "gl_scene.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{640, 480};

std::vector<std::uint8_t> picture(Renderer& renderer, const Camera& camera,
                                  const FrameOptions& options) {
    gl::Canvas canvas{camera.origin + camera.size};
    canvas.clear({1, 1, 1, 1});
    renderer.draw(camera, options, canvas.framebuffer());
    return canvas.read();
}

// epoxy's functions are variables. While a counter lives, calls of functions that make GL objects
// are counted here.
std::size_t objects_made = 0;
template <auto* function>
class Counted {
  public:
    Counted() { std::swap(original_, *function); }
    ~Counted() { std::swap(original_, *function); }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;

  private:
    using Function = std::remove_pointer_t<decltype(function)>;
    template <class... Args>
    static Function counting(void (*)(Args...)) {
        return [](Args... args) {
            ++objects_made;
            original_(args...);
        };
    }
    static inline Function original_ = counting(Function{});
};

struct ObjectCount {
    ObjectCount() { objects_made = 0; }
    Counted<&epoxy_glCreateTextures> textures;
    Counted<&epoxy_glCreateBuffers> buffers;
    Counted<&epoxy_glCreateFramebuffers> framebuffers;
    Counted<&epoxy_glCreateVertexArrays> vertex_arrays;
    Counted<&epoxy_glCreateSamplers> samplers;
};

/// Compares the samples of segments with equally many samples in both frames. uncompared: the
/// number of other segments.
struct Compared {
    std::size_t samples = 0, different = 0, segments = 0, uncompared = 0;
    double share() const { return double(different) / double(samples); }
};

Compared compare(const Renderer::Samples& a, const Renderer::Samples& b, int allowed) {
    Compared result{.segments = a.offsets.size() - 1};
    for (std::size_t i = 0; i < result.segments; ++i) {
        const std::uint32_t count = a.offsets[i + 1] - a.offsets[i];
        if (b.offsets[i + 1] - b.offsets[i] != count) {
            ++result.uncompared;
            continue;
        }
        result.samples += count;
        for (std::uint32_t j = 0; j < count; ++j) {
            const int difference = a.alpha[a.offsets[i] + j] - b.alpha[b.offsets[i] + j];
            if (std::abs(difference) > allowed) ++result.different;
        }
    }
    return result;
}

struct DepthCase {
    DepthSetup setup;
    /// The largest share of samples whose visibility differs by more than a probe.
    double most_different;
};

std::vector<DepthCase> depth_cases() {
    constexpr ClipControl d3d{.zero_to_one = true};
    return {
        {{.name = "standard_32f"}, 0.001},
        {{.name = "standard_24", .format = GL_DEPTH_COMPONENT24}, 0.001},
        {{.name = "depth_stencil_24", .format = GL_DEPTH24_STENCIL8}, 0.001},
        {{.name = "depth_stencil_32f", .format = GL_DEPTH32F_STENCIL8}, 0.001},
        {{.name = "infinite_32f", .infinite = true}, 0.001},
        {{.name = "reversed_zero_to_one", .reversed = true, .clip = d3d}, 0.001},
        {{.name = "reversed_infinite_zero_to_one", .reversed = true, .infinite = true, .clip = d3d},
         0.001},
        {{.name = "zero_to_one_24", .format = GL_DEPTH_COMPONENT24, .clip = d3d}, 0.001},
        {{.name = "depth_range", .range = {0.25F, 0.75F}}, 0.001},
        {{.name = "depth_range_backwards", .range = {1, 0}}, 0.001},
        {{.name = "upper_left", .clip = {.upper_left = true}}, 0.001},
        {{.name = "part_of_a_larger_one", .origin = {37, 11}}, 0.001},
        {{.name = "twice_as_fine", .scale = 2}, 0.001},
        {{.name = "sixteen_bits", .format = GL_DEPTH_COMPONENT16}, 0.015},
    };
}

class AppDepth : public testing::TestWithParam<DepthCase> {
  protected:
    gl::HeadlessContext context_;
};

/// Every kind of depth from a program shows the same lines as a depth of floats by the frame's own
/// camera. (The renderer's own depth hides more of them, because the renderer knows its triangles:
/// see TheProgramsDepthHidesLessThanTheRenderersOwn.)
TEST_P(AppDepth, HidesWhatPlainDepthHides) {
    const DepthSetup& setup = GetParam().setup;
    const LineSet& lines = scene_lines("house");
    Renderer renderer;
    renderer.set_lines(lines);
    AppScene app{lines};
    const gl::Canvas canvas{size};
    for (const auto& [name, camera] : scene_cameras("house", size)) {
        const FrameOptions own{.depth_scale = setup.scale, .cull_hidden = false, .steady = false};
        app.draw_depth(camera, {.name = "plain", .scale = setup.scale});
        FrameOptions plain = own;
        plain.own_depth = DepthTexture{.texture = app.depth(), .scale = setup.scale};
        renderer.draw(camera, plain, canvas.framebuffer());
        const Renderer::Samples expected = renderer.read_samples();
        // Programs choose planes with some room. Inside a model the near plane must stay.
        const glm::vec2 planes = planes_of(camera);
        const float near = name == "inside" ? planes.x : 0.2F * planes.x;
        const Camera of_app = app_camera(camera, near, 5 * planes.y, setup);
        app.draw_depth(of_app, setup);
        FrameOptions theirs = own;
        theirs.own_depth = DepthTexture{.texture = app.depth(),
                                        .origin = setup.origin,
                                        .scale = setup.scale,
                                        .range = setup.range};
        renderer.draw(of_app, theirs, canvas.framebuffer());
        const Compared result = compare(expected, renderer.read_samples(), 29);
        EXPECT_LT(result.uncompared, 1e-3 * double(result.segments)) << name;
        EXPECT_GT(result.samples, 1000U) << name;
        EXPECT_LT(result.share(), GetParam().most_different) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(, AppDepth, testing::ValuesIn(depth_cases()),
                         [](const auto& info) { return info.param.setup.name; });

/// A program with a context of the compatibility profile.
TEST(AppDepthCompatibility, ATextureDrawsTheSamePicture) {
    std::vector<std::uint8_t> pictures[2];
    const auto draw = [](std::vector<std::uint8_t>& result) {
        const LineSet& lines = scene_lines("house");
        Renderer renderer;
        renderer.set_lines(lines);
        AppScene app{lines};
        const Camera camera = scene_cameras("house", size).front().camera;
        app.draw_depth(camera, {.name = "plain"});
        result = picture(renderer, camera, {.own_depth = DepthTexture{.texture = app.depth()}});
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        GLuint cube = 0;
        glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &cube);
        EXPECT_THROW(picture(renderer, camera, {.own_depth = DepthTexture{.texture = cube}}),
                     UsageError);
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        glDeleteTextures(1, &cube);
    };
    {
        const gl::HeadlessContext core;
        draw(pictures[0]);
    }
    {
        const CompatibilityContext compatibility;
        draw(pictures[1]);
    }
    EXPECT_TRUE(equal(pictures[0], pictures[1]));
}

/// A depth buffer alone cannot tell whether a surface just before a line is the line's own.
TEST(AppDepthAlone, TheProgramsDepthHidesLessThanTheRenderersOwn) {
    const gl::HeadlessContext context;
    const LineSet& lines = scene_lines("house");
    Renderer renderer;
    renderer.set_lines(lines);
    AppScene app{lines};
    const gl::Canvas canvas{size};
    for (const auto& [name, camera] : scene_cameras("house", size)) {
        const FrameOptions own{.depth_scale = 2, .cull_hidden = false, .steady = false};
        renderer.draw(camera, own, canvas.framebuffer());
        const Renderer::Samples expected = renderer.read_samples();
        app.draw_depth(camera, {.name = "plain", .scale = 2});
        FrameOptions theirs = own;
        theirs.own_depth = DepthTexture{.texture = app.depth(), .scale = 2};
        renderer.draw(camera, theirs, canvas.framebuffer());
        const Compared result = compare(expected, renderer.read_samples(), 29);
        RecordProperty("differ_" + name, std::to_string(result.share()));
        std::cout << name << ": " << 100 * result.share() << " % of the samples differ\n";
        // In the view from inside few surfaces are so near to lines.
        if (name != "inside") {
            EXPECT_GT(result.share(), 0.05) << name;
        }
        EXPECT_LT(result.share(), 0.2) << name;
    }
}

class Embedding : public testing::Test {
  protected:
    Embedding() { renderer_.set_lines(scene_lines("house")); }

    Camera camera(glm::ivec2 of = size) const { return scene_cameras("house", of).front().camera; }
    /// Expects a UsageError whose message has `part`.
    void refuses(const FrameOptions& options, const std::string& part) {
        const gl::Canvas canvas{size};
        try {
            renderer_.draw(camera(), options, canvas.framebuffer());
            ADD_FAILURE() << "was not refused: " << part;
        } catch (const UsageError& error) {
            EXPECT_NE(std::string{error.what()}.find(part), std::string::npos) << error.what();
        }
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << part;
    }
    void refuses(const DepthTexture& depth, const std::string& part) {
        refuses(FrameOptions{.own_depth = depth}, part);
    }

    gl::HeadlessContext context_;
    Renderer renderer_;
};

TEST_F(Embedding, WrongDepthTexturesAreRefusedByName) {
    gl::Texture2D color = gl::Texture2D::create();
    glTextureStorage2D(color.id(), 1, GL_RGBA8, size.x, size.y);
    gl::Texture2D small = gl::Texture2D::create();
    glTextureStorage2D(small.id(), 1, GL_DEPTH_COMPONENT32F, size.x, size.y - 1);
    GLuint samples = 0;
    glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &samples);
    glTextureStorage2DMultisample(samples, 4, GL_DEPTH_COMPONENT32F, size.x, size.y, GL_TRUE);
    GLuint cube = 0;
    glCreateTextures(GL_TEXTURE_CUBE_MAP, 1, &cube);
    glTextureStorage2D(cube, 1, GL_DEPTH_COMPONENT32F, 640, 640);

    refuses({.texture = 4711}, "texture 4711 does not exist");
    refuses({.texture = 0}, "texture 0 does not exist");
    refuses({.texture = color.id()}, "has no depth");
    refuses({.texture = small.id()}, "has 640x479 texels");
    refuses({.texture = samples}, "multisampled");
    refuses({.texture = cube}, "not a 2D texture");
    refuses({.texture = small.id(), .scale = 5}, "scale");
    refuses({.texture = small.id(), .range = {1, 1}}, "range");
    refuses({.method = Method::opengl, .own_depth = DepthTexture{small.id()}}, "methods atlas and");
    glDeleteTextures(1, &samples);
    glDeleteTextures(1, &cube);
}

TEST_F(Embedding, TheSpineMethodTakesTheProgramsDepthToo) {
    AppScene app{scene_lines("house")};
    const Camera of_app = camera();
    app.draw_depth(of_app, {.name = "plain"});
    const FrameOptions own{.method = Method::spine, .depth_scale = 1};
    FrameOptions theirs = own;
    theirs.own_depth = DepthTexture{.texture = app.depth()};
    const ByteDifference difference =
        compare_bytes(picture(renderer_, of_app, own), picture(renderer_, of_app, theirs), 32);
    // Not exactly equal, because depth alone can't tell a line's own surface from a thin plate.
    EXPECT_LT(difference.share(), 2e-3);
}

TEST_F(Embedding, OwnDepthFollowsTheProgramsProjection) {
    const Camera plain = camera();
    const glm::vec2 planes = planes_of(plain);
    const auto expected = picture(renderer_, plain, {});
    for (const DepthCase& depth : depth_cases()) {
        if (depth.setup.clip.upper_left) continue;
        const Camera theirs = app_camera(plain, 0.5F * planes.x, 2 * planes.y, depth.setup);
        const ByteDifference difference =
            compare_bytes(expected, picture(renderer_, theirs, {}), 32);
        EXPECT_LT(difference.share(), 1e-3) << depth.setup.name;
    }
}

TEST_F(Embedding, APictureInAViewportIsThePictureAlone) {
    const glm::ivec2 low{70, 33}, part{320, 240}, whole{500, 400};
    Style style;
    style.fill.mode = FillMode::lambert;
    style.paper.grain = 0.5F;
    for (const Method method : {Method::atlas, Method::spine, Method::opengl}) {
        const FrameOptions options{.method = method, .style = style};
        gl::Canvas alone{part};
        alone.clear({0.5F, 0.5F, 0.5F, 1});
        renderer_.draw(camera(part), options, alone.framebuffer());
        gl::Canvas larger{whole};
        larger.clear({0.5F, 0.5F, 0.5F, 1});
        const float depth_before = 0.25F;
        glClearNamedFramebufferfv(larger.framebuffer(), GL_DEPTH, 0, &depth_before);
        Camera moved = camera(part);
        moved.origin = low;
        glBindFramebuffer(GL_FRAMEBUFFER, larger.framebuffer());
        renderer_.draw(moved, options, bound_framebuffer);
        float depth_beside = 0;
        glReadPixels(low.x - 1, low.y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth_beside);
        EXPECT_EQ(depth_beside, depth_before);

        const std::vector<std::uint8_t> small = alone.read(), large = larger.read();
        std::size_t outside = 0, different = 0;
        for (int y = 0; y < whole.y; ++y) {
            for (int x = 0; x < whole.x; ++x) {
                // Rows from the top.
                const glm::ivec2 at{x - low.x, y - (whole.y - low.y - part.y)};
                const auto* pixel = &large[static_cast<std::size_t>(y * whole.x + x) * 4];
                const bool inside = at.x >= 0 && at.y >= 0 && at.x < part.x && at.y < part.y;
                if (inside) {
                    const auto* expected =
                        &small[static_cast<std::size_t>(at.y * part.x + at.x) * 4];
                    // Interpolated values are rounded differently at another place.
                    const auto near = [](int a, int b) { return std::abs(a - b) <= 2; };
                    if (!std::equal(pixel, pixel + 4, expected, near)) ++different;
                } else if (pixel[0] != 128) {
                    ++outside;
                }
            }
        }
        EXPECT_EQ(different, 0U) << "method " << static_cast<int>(method);
        EXPECT_EQ(outside, 0U) << "method " << static_cast<int>(method);
    }
}

TEST_F(Embedding, AnUnknownFramebufferIsRefused) {
    EXPECT_THROW(renderer_.draw(camera(), {}, 4711), UsageError);
}

TEST_F(Embedding, TwoRenderersShareAContext) {
    Renderer other;
    other.set_lines(scene_lines("clevis"));
    const Camera of_other = scene_cameras("clevis", size).front().camera;
    const auto first = picture(renderer_, camera(), {});
    const auto second = picture(other, of_other, {});
    for (int i = 0; i < 2; ++i) {
        EXPECT_TRUE(equal(first, picture(renderer_, camera(), {})));
        EXPECT_TRUE(equal(second, picture(other, of_other, {})));
    }
}

/// The picture of a scene, drawn on this thread alone.
std::vector<std::uint8_t> picture_of(const std::string& scene) {
    const gl::HeadlessContext context;
    Renderer renderer;
    renderer.set_lines(scene_lines(scene));
    std::vector<std::uint8_t> result;
    for (const auto& [name, camera] : scene_cameras(scene, size)) {
        const auto next = picture(renderer, camera, {.steady = false});
        result.insert(result.end(), next.begin(), next.end());
    }
    return result;
}

TEST(Threads, ContextsAtOnceDrawWhatTheyDrawAlone) {
    const std::string scenes[] = {"house", "clevis"};
    std::vector<std::uint8_t> expected[2], drawn[2];
    for (int i = 0; i < 2; ++i) expected[i] = picture_of(scenes[i]);
    for (int round = 0; round < 3; ++round) {
        std::vector<std::thread> threads;
        for (int i = 0; i < 2; ++i) {
            threads.emplace_back([&, i] { drawn[i] = picture_of(scenes[i]); });
        }
        for (std::thread& thread : threads) thread.join();
        for (int i = 0; i < 2; ++i) EXPECT_TRUE(equal(expected[i], drawn[i])) << scenes[i];
    }
}

/// Lets this thread have no current context while this object lives.
class NoContext {
  public:
    NoContext() { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
    ~NoContext() { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_); }
    NoContext(const NoContext&) = delete;
    NoContext& operator=(const NoContext&) = delete;

  private:
    EGLDisplay display_ = eglGetCurrentDisplay();
    EGLContext context_ = eglGetCurrentContext();
};

TEST(Contexts, WithoutOneNothingCanBeMade) {
    EXPECT_THROW(Renderer{}, UsageError);
}

TEST_F(Embedding, WithoutItsContextOnlyAnErrorComes) {
    const gl::Canvas canvas{size};
    {
        const NoContext none;
        EXPECT_THROW(renderer_.draw(camera(), {}, canvas.framebuffer()), UsageError);
        EXPECT_THROW(renderer_.set_lines(scene_lines("house")), UsageError);
        EXPECT_THROW(renderer_.read_intervals(), UsageError);
    }
    EXPECT_NO_THROW(renderer_.draw(camera(), {}, canvas.framebuffer()));
    std::thread other{[&] {
        const gl::HeadlessContext context;
        EXPECT_THROW(renderer_.draw(camera(), {}, 0), UsageError);
    }};
    other.join();
}

TEST_F(Embedding, ARendererMayOutliveItsContext) {
    std::optional<Renderer> left{std::in_place};
    left->set_lines(scene_lines("house"));
    const gl::Canvas canvas{size};
    left->draw(camera(), {}, canvas.framebuffer());
    const NoContext none;
    left.reset();
}

TEST_F(Embedding, ARendererIsDestroyedInAnotherContextWithoutHarm) {
    std::optional<Renderer> left{std::in_place};
    left->set_lines(scene_lines("house"));
    std::thread other{[&] {
        const gl::HeadlessContext context;
        Renderer own;
        own.set_lines(scene_lines("clevis"));
        const Camera of_own = scene_cameras("clevis", size).front().camera;
        const auto before = picture(own, of_own, {});
        left.reset();
        EXPECT_TRUE(equal(before, picture(own, of_own, {})));
    }};
    other.join();
}

TEST(Contexts, AnOldGlIsNamed) {
    const gl::HeadlessContext context;
    const EGLDisplay display = eglGetCurrentDisplay();
    const EGLContext before = eglGetCurrentContext();
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    const EGLContext old = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    ASSERT_NE(old, EGL_NO_CONTEXT);
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, old);
    try {
        const Renderer renderer;
        ADD_FAILURE() << "made a renderer";
    } catch (const DeviceError& error) {
        EXPECT_NE(std::string{error.what()}.find("OpenGL ES 3"), std::string::npos) << error.what();
        EXPECT_NE(std::string{error.what()}.find("4.5"), std::string::npos) << error.what();
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, old);
    eglBindAPI(EGL_OPENGL_API);
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, before);
}

TEST(Contexts, ADestroyedOneLeavesTheCurrentOne) {
    gl::HeadlessContext current;
    const EGLContext expected = eglGetCurrentContext();
    {
        const gl::HeadlessContext other;
        ASSERT_NE(eglGetCurrentContext(), expected);
        current.make_current();
    }
    EXPECT_EQ(eglGetCurrentContext(), expected);
    EXPECT_NO_THROW(Renderer{});
    { const gl::HeadlessContext other; }
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

TEST_F(Embedding, AFrameAllocatesNothingAfterTheFirst) {
    AppScene app{scene_lines("house")};
    const gl::Canvas canvas{size};
    const std::vector<NamedCamera> cameras = scene_cameras("house", size);
    app.draw_depth(cameras[0].camera, {.name = "plain"});
    FrameOptions with_depth;
    with_depth.own_depth = DepthTexture{.texture = app.depth()};
    Style style;
    style.pen.mark = "pencil";
    style.fill.mode = FillMode::lambert;
    style.filter.overshoot = 4;
    for (const FrameOptions& options :
         {FrameOptions{}, FrameOptions{.forms = {.atlas = StageForm::raster}},
          FrameOptions{.style = style}, with_depth, FrameOptions{.method = Method::item_buffer}}) {
        for (int i = 0; i < 4; ++i) {
            renderer_.draw(cameras[i % 2].camera, options, canvas.framebuffer());
        }
        const ObjectCount objects;
        AllocationCount count;
        for (int i = 0; i < 4; ++i) {
            renderer_.draw(cameras[i % 2].camera, options, canvas.framebuffer());
        }
        EXPECT_EQ(count.stop(), 0U);
        EXPECT_EQ(objects_made, 0U);
    }
    const ObjectCount objects;
    AllocationCount count;
    renderer_.set_lines(scene_lines("house"));
    EXPECT_GT(count.stop(), 0U);
    EXPECT_GT(objects_made, 0U);
}

} // namespace
} // namespace lineatlas::test
