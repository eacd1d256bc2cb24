// Every call refuses wrong arguments in the same words before it draws anything, and leaves the
// renderer as it was.

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/assembly.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{160, 120};
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float endless = std::numeric_limits<float>::infinity();

/// The message of the UsageError that a call throws; empty if it throws none.
std::string refusal(const std::function<void()>& call) {
    try {
        call();
    } catch (const UsageError& error) {
        return error.what();
    }
    return {};
}

bool is_one_line(const std::string& message) {
    return !message.empty() && message.size() < 300 && message.find('\n') == std::string::npos;
}

class Refusals : public testing::Test {
  protected:
    Refusals() {
        renderer_.set_lines(lines_);
        visibility_.emplace(lines_);
        intervals_ = visibility_->find(camera_);
        expected_ = picture();
    }

    std::vector<std::uint8_t> picture() {
        canvas_.clear({1, 1, 1, 1});
        renderer_.draw(camera_, {.steady = false}, canvas_.framebuffer());
        return canvas_.read();
    }

    void draw_tiles(const Camera& camera, const FrameOptions& options) {
        const auto nothing = [](const PictureTile&) {};
        renderer_.draw_tiles(camera, options, {canvas_.framebuffer(), 64, nothing, nothing});
    }

    /// Expects that the call is refused, that it draws nothing and leaves no error of GL, and that
    /// the next picture is the same as before. Returns the message.
    std::string refuses(const std::string& what, const std::function<void()>& call) {
        canvas_.clear({0.25F, 0.5F, 0.75F, 1});
        const std::vector<std::uint8_t> before = canvas_.read();
        const std::string message = refusal(call);
        EXPECT_TRUE(is_one_line(message)) << what << ": " << message;
        EXPECT_TRUE(equal(before, canvas_.read())) << what << " was refused after it was drawn";
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << what;
        EXPECT_TRUE(equal(expected_, picture())) << "the picture after " << what;
        return message;
    }

    gl::HeadlessContext context_;
    const LineSet& lines_ = scene_lines("clevis");
    Camera camera_ = scene_cameras("clevis", size).front().camera;
    Renderer renderer_;
    std::optional<LineVisibility> visibility_;
    std::vector<Interval> intervals_;
    gl::Canvas canvas_{size};
    std::vector<std::uint8_t> expected_;
};

struct WrongOptions {
    std::string part; ///< of the message
    std::function<void(FrameOptions&)> set;
};

std::vector<WrongOptions> wrong_styles() {
    const auto style = [](std::function<void(Style&)> set) {
        return [set](FrameOptions& options) { set(options.style); };
    };
    return {
        {"paper-grain must be a number from 0 to 1, not 2",
         style([](Style& s) { s.paper.grain = 2; })},
        {"opacity must be a number from 0 to 1, not 7", style([](Style& s) { s.pen.opacity = 7; })},
        {"mitre-limit must be a number from 1 to 100",
         style([](Style& s) { s.pen.mitre_limit = -3; })},
        {"cap-length must be", style([](Style& s) { s.pen.cap_length = -5; })},
        {"density must be", style([](Style& s) { s.density.limit = -1; })},
        {"halo must be", style([](Style& s) { s.filter.halo = -4; })},
        {"halo must be a number from 0 to 10000 pixels, or a length on paper as \"0.5mm\", not nan",
         style([](Style& s) { s.filter.halo = nan; })},
        {"join must be one of", style([](Style& s) { s.pen.join = Join{99}; })},
        {"hidden-width must be", style([](Style& s) { s.hidden_pen.width = endless; })},
        {"rule 2 of pens: width must be", style([](Style& s) {
             s.pens = {{.color = glm::vec3{1, 0, 0}}, {.width = -2}};
         })},
        {"rule 1 of pens: width must be", style([](Style& s) {
             s.pen.width = 900;
             s.pens = {{.width_factor = 2}};
         })},
        {"rule 1 of pens: width-factor must be",
         style([](Style& s) { s.pens = {{.width_factor = nan}}; })},
        {"there is no kind \"creese\"; did you mean \"crease\"?",
         style([](Style& s) { s.pens = {{.match = {.kinds = {"creese"}}, .width = 2}}; })},
    };
}

std::vector<WrongOptions> wrong_options() {
    std::vector<WrongOptions> wrong = wrong_styles();
    const auto no_picture = [](std::string& mark) { mark = "./there_is_none.png"; };
    const std::vector<WrongOptions> others{
        {"no picture for the mark", [=](FrameOptions& o) { no_picture(o.style.pen.mark); }},
        {"no picture for the mark",
         [=](FrameOptions& o) {
             o.style.hidden = true;
             no_picture(o.style.hidden_pen.mark);
         }},
        {"no picture for the mark",
         [=](FrameOptions& o) { no_picture(o.style.pens.emplace_back().mark.emplace()); }},
        {"probes must be one of 1, 4, 9, 16, not 7", [](FrameOptions& o) { o.probes = 7; }},
        {"depth-scale must be", [](FrameOptions& o) { o.depth_scale = 9; }},
        {"step must be", [](FrameOptions& o) { o.step = nan; }},
        {"step must be", [](FrameOptions& o) { o.step = 1e6F; }},
        {"method must be one of", [](FrameOptions& o) { o.method = Method{99}; }},
        {"strokes must be one of", [](FrameOptions& o) { o.forms.strokes = StageForm{9}; }},
        {"intervals must be one of", [](FrameOptions& o) { o.intervals = KeptIntervals{9}; }},
    };
    wrong.insert(wrong.end(), others.begin(), others.end());
    return wrong;
}

TEST_F(Refusals, OptionsOutOfRangeDrawNothing) {
    for (const auto& [part, set] : wrong_options()) {
        for (const Method method : {Method::atlas, Method::exact, Method::opengl}) {
            FrameOptions options{.method = method, .steady = false};
            set(options);
            const std::string drawn =
                refuses(part, [&] { renderer_.draw(camera_, options, canvas_.framebuffer()); });
            EXPECT_NE(drawn.find(part), std::string::npos) << drawn;
            if (method == Method::opengl) continue;
            EXPECT_EQ(drawn, refuses(part, [&] { draw_tiles(camera_, options); }));
        }
    }
}

TEST_F(Refusals, StylesOutOfRangeMakeNoPaths) {
    for (const auto& [part, set] : wrong_styles()) {
        FrameOptions options;
        set(options);
        const std::string message =
            refusal([&] { make_vector_drawing(lines_, camera_, intervals_, options.style); });
        EXPECT_NE(message.find(part), std::string::npos) << message;
    }
}

TEST_F(Refusals, DrawingsThatWereChangedAreChecked) {
    const VectorDrawing drawing = make_vector_drawing(lines_, camera_, intervals_, {});
    const std::pair<std::string, std::function<void(VectorDrawing&)>> changes[] = {
        {"width must be", [](VectorDrawing& d) { d.style.pen.width = -1; }},
        {"width must be", [](VectorDrawing& d) { d.pens.front().width = nan; }},
        {"opacity must be", [](VectorDrawing& d) { d.hidden_pens.front().opacity = 7; }},
        {"paper must be", [](VectorDrawing& d) { d.style.paper.color.x = nan; }},
        {"has the pen 5", [](VectorDrawing& d) { d.paths.front().pen = 5; }},
        {"0x0",
         [](VectorDrawing& d) {
             d.size = {0, 0};
         }},
    };
    for (const auto& [part, change] : changes) {
        VectorDrawing changed = drawing;
        change(changed);
        for (const std::string& message :
             {refusal([&] { to_svg(changed); }), refusal([&] { to_dxf(changed); }),
              refusal([&] { to_json(changed); })}) {
            EXPECT_NE(message.find(part), std::string::npos) << part << ": " << message;
        }
    }
    VectorDrawing large = drawing;
    large.pens.front().width = 5000; // of a picture of many pixels, see Style::made_for
    EXPECT_FALSE(to_svg(large).empty());
}

TEST_F(Refusals, TargetsAreLookedAtFirst) {
    const gl::Framebuffer empty = gl::Framebuffer::create();
    const gl::Texture2D color = gl::Texture2D::create();
    glTextureStorage2D(color.id(), 1, GL_RGBA8, size.x, size.y);
    const gl::Framebuffer flat = gl::Framebuffer::create();
    glNamedFramebufferTexture(flat.id(), GL_COLOR_ATTACHMENT0, color.id(), 0);
    const FrameOptions lines{.method = Method::opengl};
    const auto message = [&](GLuint framebuffer, const FrameOptions& options) {
        return refuses("a target", [&] { renderer_.draw(camera_, options, framebuffer); });
    };
    EXPECT_NE(message(empty.id(), {}).find("not complete"), std::string::npos);
    EXPECT_NE(message(0, {}).find("no framebuffer of its own"), std::string::npos);
    EXPECT_NE(message(flat.id(), lines).find("no depth attachment"), std::string::npos);
}

std::vector<std::pair<std::string, std::function<void(Camera&)>>> wrong_cameras() {
    return {
        {"projection matrix is not finite", [](Camera& c) { c.projection[0][0] = nan; }},
        {"projection matrix is not finite", [](Camera& c) { c.projection[2][3] = -endless; }},
        {"projection matrix is singular", [](Camera& c) { c.projection = glm::mat4{0}; }},
        {"projection matrix is singular", [](Camera& c) { c.projection[1][1] = 0; }},
        {"view matrix is not finite", [](Camera& c) { c.view[3][0] = nan; }},
        {"view matrix is not finite", [](Camera& c) { c.view[3][1] = endless; }},
        {"view matrix is singular", [](Camera& c) { c.view = glm::mat4{0}; }},
        {"view matrix is singular", [](Camera& c) { c.view[1] = c.view[2]; }},
        {"product of projection and view is not finite",
         [](Camera& c) {
             c.view[3] = {3e38F, 3e38F, 3e38F, 1};
         }},
        {"each side must be",
         [](Camera& c) {
             c.size = {0, 0};
         }},
        {"each side must be",
         [](Camera& c) {
             c.size = {-5, 10};
         }},
    };
}

TEST_F(Refusals, CamerasThatShowNothingAreRefusedAlike) {
    for (const auto& [part, change] : wrong_cameras()) {
        Camera camera = camera_;
        change(camera);
        const std::string drawn =
            refuses(part, [&] { renderer_.draw(camera, {}, canvas_.framebuffer()); });
        EXPECT_NE(drawn.find(part), std::string::npos) << drawn;
        EXPECT_EQ(drawn, refuses(part, [&] { draw_tiles(camera, {}); }));
        EXPECT_EQ(drawn, refuses(part, [&] { renderer_.pick(camera, {1, 1}, 1); }));
        EXPECT_EQ(drawn, refusal([&] { visibility_->find(camera); }));
        EXPECT_EQ(drawn, refusal([&] { visibility_->pick(camera, {1, 1}, 1); }));
        EXPECT_EQ(drawn, refusal([&] { make_vector_drawing(lines_, camera, intervals_, {}); }));
    }
}

TEST_F(Refusals, CamerasOfOddKindsAreTaken) {
    Camera endless_far = camera_; // reversed, with the far plane infinitely far away
    endless_far.projection[2][2] = 0;
    endless_far.projection[3][2] = 0.1F;
    endless_far.clip.zero_to_one = true;
    Camera far_away = camera_;
    far_away.view = far_away.view * glm::translate(glm::mat4{1}, {1e6F, -1e6F, 1e6F});
    Camera tiny = camera_; // of a model a billion times as large
    tiny.view = tiny.view * glm::scale(glm::mat4{1}, glm::vec3{1e-9F});
    for (const Camera& camera : {endless_far, far_away, tiny}) {
        EXPECT_NO_THROW(renderer_.draw(camera, {}, canvas_.framebuffer()));
        EXPECT_NO_THROW(visibility_->find(camera));
    }
}

TEST_F(Refusals, LineSetsWithIndicesOutOfRangeAreNotTaken) {
    LineSet wrong = lines_;
    wrong.segments[3].p = 0x7FFFFFFF;
    const std::string expected = "line set: segment 3 has the index 2147483647, but there are " +
                                 std::to_string(lines_.vertices.size()) + " vertices";
    EXPECT_EQ(expected, refuses("set_lines", [&] { renderer_.set_lines(wrong); }));
    EXPECT_EQ(expected, refusal([&] { LineVisibility{wrong}; }));
    EXPECT_EQ(expected, refusal([&] { visibility_->set_lines(wrong); }));
    EXPECT_EQ(visibility_->find(camera_).size(), intervals_.size()) << "lines of before";
    Assembly parts;
    EXPECT_EQ(expected, refusal([&] { parts.add(wrong); }));
    EXPECT_EQ(expected, refusal([&] { make_vector_drawing(wrong, camera_, intervals_, {}); }));
}

} // namespace
} // namespace lineatlas::test
