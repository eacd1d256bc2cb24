// GL state of a program that embeds the renderer stays as it is, and changes no picture.

#include <algorithm>
#include <functional>
#include <optional>
#include <variant>

#include <gtest/gtest.h>

#include "compare.hpp"
#include "compatibility_context.hpp"
#include "gl_state.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/compatibility_state.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{320, 240};

/// Draws once, and reads the picture.
using Drawing = std::function<void(Renderer&, const gl::Canvas&)>;

Camera camera() {
    return scene_cameras("house", size).front().camera;
}

Drawing drawing(const FrameOptions& options) {
    return [options](Renderer& renderer, const gl::Canvas& canvas) {
        renderer.draw(camera(), options, canvas.framebuffer());
    };
}

Style rich_style() {
    Style style;
    style.pen.mark = "pencil";
    style.hidden = true;
    style.fill.mode = FillMode::lambert;
    style.paper.grain = 0.4F;
    style.density.limit = 0.3F;
    style.filter.halo = 3;
    return style;
}

/// Every way to draw, by name.
std::vector<std::pair<std::string, Drawing>> drawings() {
    std::vector<std::pair<std::string, Drawing>> all{
        {"atlas", drawing({})},
        {"raster", drawing({.forms = {.atlas = StageForm::raster}})},
        {"spine", drawing({.method = Method::spine})},
        {"item buffer", drawing({.method = Method::item_buffer})},
        {"opengl", drawing({.method = Method::opengl})},
        {"style", drawing({.style = rich_style()})},
        {"opengl with fill", drawing({.method = Method::opengl, .style = rich_style()})},
    };
    all.emplace_back("tiles", [](Renderer& renderer, const gl::Canvas& canvas) {
        const auto nothing = [](const PictureTile&) {};
        renderer.draw_tiles(camera(), {.style = rich_style()},
                            {canvas.framebuffer(), 512, nothing, nothing});
    });
    all.emplace_back("readback", [](Renderer& renderer, const gl::Canvas& canvas) {
        renderer.draw(camera(), {.intervals = KeptIntervals::all}, canvas.framebuffer());
        EXPECT_FALSE(renderer.read_intervals().empty());
        EXPECT_FALSE(renderer.read_samples().alpha.empty());
    });
    return all;
}

enum class Profile { core, compatibility };

/// A context of either profile.
struct Context {
    explicit Context(Profile profile) {
        if (profile == Profile::core)
            context.emplace<gl::HeadlessContext>();
        else
            context.emplace<CompatibilityContext>();
    }
    std::variant<std::monostate, gl::HeadlessContext, CompatibilityContext> context;
};

/// A fresh context with a renderer; in an odd state if asked for.
struct Program {
    Program(Profile profile, bool odd)
        : context(profile), canvas(size), depth_stencil(gl::Renderbuffer::create()) {
        // A canvas has no stencil for a test to fail on.
        glNamedRenderbufferStorage(depth_stencil.id(), GL_DEPTH32F_STENCIL8, size.x, size.y);
        glNamedFramebufferRenderbuffer(canvas.framebuffer(), GL_DEPTH_STENCIL_ATTACHMENT,
                                       GL_RENDERBUFFER, depth_stencil.id());
        canvas.clear({1, 1, 1, 1});
        if (odd) state.emplace();
        before = dump_state();
        renderer.emplace();
        check("constructor");
        renderer->set_lines(scene_lines("house"));
        check("set_lines");
    }
    void check(const std::string& call) {
        EXPECT_EQ(differences(before, dump_state()), "") << "after " << call;
    }
    /// Reads in another context in its initial state, so that no odd state disturbs the reading.
    std::vector<std::uint8_t> read() {
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
        for (const GLenum name :
             {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT,
              GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES}) {
            glPixelStorei(name, 0);
        }
        if (gl::is_compatibility()) reset_transfers();
        return canvas.read();
    }
    static void reset_transfers() {
        glPixelTransferi(GL_MAP_COLOR, GL_FALSE);
        for (const GLenum scale : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE})
            glPixelTransferf(scale, 1);
        for (const GLenum bias : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS})
            glPixelTransferf(bias, 0);
    }

    Context context;
    gl::Canvas canvas;
    gl::Renderbuffer depth_stencil;
    std::optional<OddState> state;
    std::vector<StateValue> before;
    std::optional<Renderer> renderer;
};

class GlState : public testing::TestWithParam<std::tuple<Profile, std::size_t>> {};

TEST_P(GlState, StaysAndChangesNoPicture) {
    const auto [profile, number] = GetParam();
    const auto [name, draw] = drawings()[number];
    std::vector<std::uint8_t> pictures[2];
    for (const bool odd : {false, true}) {
        Program program{profile, odd};
        for (int frame = 0; frame < 2; ++frame) {
            draw(*program.renderer, program.canvas);
            program.check(name);
        }
        program.renderer.reset();
        program.check("destructor");
        pictures[odd ? 1 : 0] = program.read();
    }
    EXPECT_TRUE(equal(pictures[0], pictures[1])) << name;
    const auto white = std::ranges::count(pictures[0], std::uint8_t{255});
    EXPECT_LT(white, static_cast<std::ptrdiff_t>(pictures[0].size())) << "nothing was drawn";
}

INSTANTIATE_TEST_SUITE_P(, GlState,
                         testing::Combine(testing::Values(Profile::core, Profile::compatibility),
                                          testing::Range(std::size_t{0}, drawings().size())));

class GlStateDump : public testing::TestWithParam<Profile> {};

TEST_P(GlStateDump, SeesChangedState) {
    const Context context{GetParam()};
    const auto before = dump_state();
    glLineWidth(1.5F);
    glBindSampler(3, 0);
    EXPECT_NE(differences(before, dump_state()).find("GL_LINE_WIDTH"), std::string::npos);
    glLineWidth(1);
    EXPECT_EQ(differences(before, dump_state()), "");
    const OddState odd;
    EXPECT_GT(differences(before, dump_state()).size(), 10'000U);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

INSTANTIATE_TEST_SUITE_P(, GlStateDump, testing::Values(Profile::core, Profile::compatibility));

void take_errors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

/// Expects that the call is refused with a message that contains `part`.
void expect_refused(const std::function<void()>& call, const std::string& part) {
    try {
        call();
        ADD_FAILURE() << "was not refused: " << part;
    } catch (const UsageError& error) {
        EXPECT_NE(std::string{error.what()}.find(part), std::string::npos) << error.what();
    }
}

TEST(GlStateCompatibility, CallsAreRefusedInContextsThatCannotDraw) {
    const CompatibilityContext context;
    Renderer renderer;
    const LineSet& lines = scene_lines("house");
    renderer.set_lines(lines);
    const gl::Canvas canvas{size};
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer()); // none is bound at the start
    const std::function<void()> calls[] = {
        [&] { renderer.draw(camera(), {}, canvas.framebuffer()); },
        [&] { renderer.set_lines(lines); },
        [&] {
            renderer.pick(camera(), {1, 1}, 1);
        },
        [] { Renderer{}; },
    };
    for (const auto& call : calls) {
        glNewList(1, GL_COMPILE);
        expect_refused(call, "glNewList");
        glEndList();
        glNewList(1, GL_COMPILE_AND_EXECUTE);
        expect_refused(call, "glNewList");
        glEndList();
        GLuint selected[4]{};
        glSelectBuffer(4, selected);
        glRenderMode(GL_SELECT);
        expect_refused(call, "glRenderMode");
        glRenderMode(GL_RENDER);
        glBegin(GL_TRIANGLES);
        expect_refused(call, "glBegin");
        glEnd();
        take_errors(); // between glBegin() and glEnd() errors can't be read
        EXPECT_NO_THROW(call());
    }
}

TEST(GlStateFeedback, NothingIsDrawnWithinOne) {
    const gl::HeadlessContext context;
    Renderer renderer;
    renderer.set_lines(scene_lines("house"));
    const char* source = "#version 450 core\nvoid main() { gl_Position = vec4(1.0); }";
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    const GLuint program = glCreateProgram();
    glAttachShader(program, shader);
    const char* varying = "gl_Position";
    glTransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    const gl::Buffer buffer = gl::Buffer::create();
    glNamedBufferStorage(buffer.id(), 1024, nullptr, 0);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer.id());
    glUseProgram(program);
    glBeginTransformFeedback(GL_POINTS);
    ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    const gl::Canvas canvas{size};
    EXPECT_THROW(renderer.draw(camera(), {}, canvas.framebuffer()), UsageError);
    glPauseTransformFeedback();
    EXPECT_NO_THROW(renderer.draw(camera(), {}, canvas.framebuffer()));
    glEndTransformFeedback();
    glUseProgram(0);
    glDeleteProgram(program);
    glDeleteShader(shader);
}

} // namespace
} // namespace lineatlas::test
