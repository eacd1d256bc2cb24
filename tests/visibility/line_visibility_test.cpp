// Lines without GL. LineVisibility finds the same intervals as a renderer's exact frames, bit by
// bit, and refuses the same calls.

#include "lineatlas/visibility.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <thread>

#include <glm/gtc/matrix_transform.hpp>

#include "compare.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/assembly.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace {

/// Finds intervals by a renderer.
class ByRenderer {
  public:
    explicit ByRenderer(const LineSet& lines, const DeviceOptions& options = {})
        : renderer_(options) {
        renderer_.set_lines(lines);
    }
    std::vector<Interval> find(const Camera& camera, const VisibilityOptions& options = {}) {
        FrameOptions frame;
        frame.method = Method::exact;
        frame.lines = options.lines;
        frame.step = options.step;
        frame.intervals = options.hidden ? KeptIntervals::all : KeptIntervals::visible;
        frame.draw = false;
        renderer_.draw(camera, frame, 0);
        return renderer_.read_intervals();
    }
    Renderer& renderer() { return renderer_; }

  private:
    gl::HeadlessContext context_;
    Renderer renderer_;
};

Camera camera_on(const LineSet& lines, glm::ivec2 size = {400, 300}) {
    return make_camera({.eye = {4, 5, 8}, .target = {0, 0, 0}}, size, lines.bounds);
}

/// The result of a call: intervals, or the text of its error.
template <class Find>
std::string outcome(Find&& find) {
    try {
        const std::vector<Interval> found = find();
        return std::to_string(found.size()) + " intervals";
    } catch (const UsageError& error) {
        return std::string{"usage: "} + error.what();
    } catch (const Error& error) {
        return error.what();
    }
}

class OnDevice : public testing::TestWithParam<const char*> {
  protected:
    DeviceOptions device() const { return {.compute = GetParam()}; }
};

TEST_P(OnDevice, FindsWhatARendererFindsBitByBit) {
    for (const char* name : {"clevis", "house"}) {
        const LineSet& lines = scene_lines(name);
        LineVisibility visibility{lines, device()};
        DeviceOptions of_once = device();
        of_once.one_picture = true;
        LineVisibility once{lines, of_once}; // it can be asked again
        ByRenderer renderer{lines, device()};
        for (const NamedCamera& view : scene_cameras(name, {640, 480})) {
            for (const bool hidden : {false, true}) {
                const VisibilityOptions wanted{.hidden = hidden};
                const std::vector<Interval> found = visibility.find(view.camera, wanted);
                EXPECT_GT(found.size(), 10U) << name << ", " << view.name;
                EXPECT_TRUE(same_bits(found, renderer.find(view.camera, wanted)))
                    << name << ", " << view.name << (hidden ? ", hidden too" : "");
                EXPECT_TRUE(same_bits(found, once.find(view.camera, wanted))) << name;
            }
        }
    }
}

TEST_P(OnDevice, TakesOtherKindsStepsAndLines) {
    const LineSet& clevis = scene_lines("clevis");
    LineVisibility visibility{clevis, device()};
    const Camera camera = scene_cameras("clevis").front().camera;
    const std::size_t all = visibility.find(camera).size();
    ByRenderer renderer{clevis, device()};
    for (const VisibilityOptions& wanted :
         {VisibilityOptions{.lines = mask_of(LineKind::silhouette)},
          VisibilityOptions{.hidden = true, .step = 40}}) {
        const std::vector<Interval> found = visibility.find(camera, wanted);
        EXPECT_NE(found.size(), all);
        EXPECT_TRUE(same_bits(found, renderer.find(camera, wanted)));
    }
    const LineSet box = extract_lines(cube());
    visibility.set_lines(box);
    EXPECT_TRUE(
        same_bits(visibility.find(camera_on(box)), ByRenderer(box, device()).find(camera_on(box))));
}

/// A cube and a ball before it, whose silhouettes are smooth: two objects.
LineSet cube_and_ball() {
    Mesh mesh = cube();
    mesh.triangle_object.assign(mesh.triangles.size(), 0);
    const Mesh ball = sphere(3);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& p : ball.positions)
        mesh.positions.push_back(0.5F * p + glm::vec3{1, 1, 2});
    for (const glm::uvec3& t : ball.triangles) {
        mesh.triangles.push_back(t + first);
        mesh.triangle_object.push_back(1);
    }
    return extract_lines(mesh, {.separate_objects = true});
}

TEST_P(OnDevice, MovesAsARendererDoes) {
    const LineSet lines = cube_and_ball();
    ASSERT_FALSE(lines.contours.empty());
    ASSERT_EQ(lines.objects.size(), 2U);
    const Camera camera = camera_on(lines);
    LineVisibility visibility{lines, device()};
    ByRenderer renderer{lines, device()};
    const VisibilityOptions all{.hidden = true};
    std::vector<Interval> before = visibility.find(camera, all);
    ASSERT_TRUE(same_bits(before, renderer.find(camera, all)));
    const auto expect_change = [&](const char* what, const auto& change) {
        SCOPED_TRACE(what);
        change(visibility);
        change(renderer.renderer());
        const std::vector<Interval> found = visibility.find(camera, all);
        EXPECT_FALSE(same_bits(found, before)) << "nothing has changed";
        EXPECT_TRUE(same_bits(found, renderer.find(camera, all)));
        before = found;
    };
    const glm::mat4 still{1};
    const std::array there{still, glm::translate(still, {-1, 0.2F, -0.5F})};
    const std::array turned{glm::rotate(still, 0.4F, {0, 1, 0}), glm::scale(still, {1, 2, 1})};
    expect_change("transforms", [&](auto& of) { of.set_transforms(there); });
    expect_change("other transforms", [&](auto& of) { of.set_transforms(turned); });
    std::vector<glm::vec3> bent = lines.vertices;
    for (glm::vec3& p : bent) p.x += 0.2F * p.y * p.y;
    expect_change("positions", [&](auto& of) { of.set_positions(0, bent); });
    expect_change("hidden", [&](auto& of) { of.set_hidden(std::array{1U}); });
    expect_change("shown again", [&](auto& of) { of.set_hidden({}); });
    expect_change("all as it was made", [&](auto& of) { of.set_lines(lines); });
    EXPECT_TRUE(same_bits(before, LineVisibility(lines, device()).find(camera, all)));
    EXPECT_THROW(visibility.set_transforms({}), UsageError);
    EXPECT_THROW(visibility.set_positions(1, bent), UsageError);
    EXPECT_THROW(visibility.set_hidden(std::array{2U}), UsageError);
    EXPECT_TRUE(same_bits(visibility.find(camera, all), before))
        << "what is refused changes nothing";
    const std::optional<Pick> on_ball = visibility.pick(camera, {200, 150}, 1000);
    ASSERT_TRUE(on_ball);
    visibility.set_hidden(std::array{0U, 1U});
    EXPECT_FALSE(visibility.pick(camera, {200, 150}, 1000)) << "what is hidden is not met";
}

TEST_P(OnDevice, TakesAssemblies) {
    Assembly parts;
    parts.add(extract_lines(cube()));
    const std::vector<std::uint32_t> ball = parts.add(cube_and_ball());
    LineVisibility visibility{extract_lines(cube()), device()};
    const Camera camera = camera_on(parts.lines());
    const std::size_t one = visibility.find(camera).size();
    visibility.set_lines(parts);
    EXPECT_GT(visibility.find(camera).size(), one);
    for (const std::uint32_t object : ball) parts.remove(object);
    visibility.set_lines(parts);
    EXPECT_EQ(visibility.find(camera).size(), one);
}

TEST_P(OnDevice, OfACubeNineEdgesAreVisibleAndThreeHidden) {
    const LineSet lines = extract_lines(cube());
    LineVisibility visibility{lines, device()};
    const std::vector<Interval> found = visibility.find(camera_on(lines), {.hidden = true});
    const auto visible = std::ranges::count_if(
        found, [](const Interval& i) { return (i.flags & LA_INTERVAL_VISIBLE) != 0; });
    EXPECT_EQ(visible, 9);
    EXPECT_EQ(found.size(), 12U);
}

INSTANTIATE_TEST_SUITE_P(LineVisibility, OnDevice, testing::Values("", "cpp"),
                         [](const auto& device) {
                             return *device.param == '\0' ? "automatic" : device.param;
                         });

TEST(LineVisibility, RefusesWhatARendererRefuses) {
    const LineSet lines = extract_lines(cube());
    const Camera good = camera_on(lines);
    LineVisibility visibility{lines};
    ByRenderer renderer{lines};
    const std::vector<Interval> before = visibility.find(good);
    for (const glm::ivec2 size : {glm::ivec2{0, 0}, {0, 10}, {10, -1}, {65537, 10}}) {
        Camera camera = good;
        camera.size = size;
        const std::string said = outcome([&] { return visibility.find(camera); });
        EXPECT_TRUE(said.starts_with("usage: a picture of ")) << said;
        EXPECT_EQ(said, outcome([&] { return renderer.find(camera); }));
    }
    const VisibilityOptions no_step{.step = 0};
    const std::string said = outcome([&] { return visibility.find(good, no_step); });
    EXPECT_TRUE(said.starts_with("usage: step")) << said;
    EXPECT_EQ(said, outcome([&] { return renderer.find(good, no_step); }));
    EXPECT_TRUE(same_bits(visibility.find(good), before)) << "all is as it was";
}

TEST(LineVisibility, OfCamerasThatAreNotFiniteItGivesWhatARendererGives) {
    const LineSet lines = extract_lines(cube());
    LineVisibility visibility{lines};
    ByRenderer renderer{lines};
    const Camera good = camera_on(lines);
    const std::vector<Interval> before = visibility.find(good);
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Camera camera = good;
        camera.view[3][0] = value;
        EXPECT_EQ(outcome([&] { return visibility.find(camera); }),
                  outcome([&] { return renderer.find(camera); }));
        camera = good;
        camera.projection[0][0] = value;
        EXPECT_EQ(outcome([&] { return visibility.find(camera); }),
                  outcome([&] { return renderer.find(camera); }));
    }
    EXPECT_TRUE(same_bits(visibility.find(good), before));
}

TEST(LineVisibility, OfNoLinesItFindsNone) {
    const LineSet none;
    LineVisibility visibility{none};
    Camera camera;
    camera.size = {100, 100};
    camera.view = glm::lookAt(glm::vec3{0, 0, 5}, glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = glm::perspective(1.0F, 1.0F, 1.0F, 10.0F);
    EXPECT_TRUE(visibility.find(camera, {.hidden = true}).empty());
    EXPECT_TRUE(ByRenderer{none}.find(camera, {.hidden = true}).empty());
}

TEST(LineVisibility, RefusesDevicesThatThereAreNot) {
    const LineSet lines = extract_lines(cube());
    EXPECT_THROW((LineVisibility{lines, {.compute = "abacus"}}), UsageError);
    EXPECT_THROW((LineVisibility{lines, {.device = "opencl:no such platform"}}), Error);
    EXPECT_THROW((LineVisibility{lines, {.interop = "copy"}}), UsageError);
}

TEST(LineVisibility, IsComparedWithAnotherDevice) {
    const LineSet& lines = scene_lines("clevis");
    LineVisibility visibility{lines, {.compute = "cpp", .compare_with = "cpp"}};
    const Camera camera = scene_cameras("clevis").front().camera;
    EXPECT_TRUE(
        same_bits(visibility.find(camera), LineVisibility(lines, {.compute = "cpp"}).find(camera)));
}

TEST(LineVisibility, SaysWhatItRunsOnAndMoves) {
    const LineSet lines = extract_lines(cube());
    LineVisibility first{lines, {.compute = "cpp"}};
    EXPECT_TRUE(first.description().starts_with("cpp")) << first.description();
    const std::vector<Interval> found = first.find(camera_on(lines));
    LineVisibility second = std::move(first);
    EXPECT_TRUE(same_bits(second.find(camera_on(lines)), found));
}

TEST(LineVisibility, DifferentOnesWorkAtTheSameTime) {
    const LineSet& lines = scene_lines("clevis");
    const Camera camera = scene_cameras("clevis").front().camera;
    const std::vector<Interval> expected = LineVisibility{lines}.find(camera);
    const auto work = [&](int& equal) {
        LineVisibility visibility{lines};
        for (int i = 0; i < 5; ++i) equal += same_bits(visibility.find(camera), expected) ? 1 : 0;
    };
    int first = 0, second = 0;
    std::thread thread{[&] { work(first); }};
    work(second);
    thread.join();
    EXPECT_EQ(first, 5);
    EXPECT_EQ(second, 5);
}

} // namespace
} // namespace lineatlas::test
