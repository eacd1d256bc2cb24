// Intervals of lines that the whole renderer finds: in drawings with known answers and in the
// built-in scenes, with OpenCL and plain C++, and with the raster and the compute atlas.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace {

constexpr int side = 400;

Camera pixel_camera() {
    Camera camera;
    camera.size = {side, side};
    camera.view = glm::lookAt(glm::vec3{0, 0, 200}, glm::vec3{0, 0, 0}, glm::vec3{0, 1, 0});
    camera.projection = glm::ortho(0.0F, float{side}, 0.0F, float{side}, 1.0F, 401.0F);
    return camera;
}

bool is_visible(const Interval& interval) {
    return (interval.flags & LA_INTERVAL_VISIBLE) != 0;
}
glm::vec2 start_of(const Interval& interval) {
    return {interval.start[0], interval.start[1]};
}
glm::vec2 end_of(const Interval& interval) {
    return {interval.end[0], interval.end[1]};
}
float length_of(const Interval& interval) {
    return glm::distance(start_of(interval), end_of(interval));
}

struct Form {
    const char* compute;
    StageForm atlas;
    std::string name() const {
        return std::string{compute} + (atlas == StageForm::raster ? "_raster" : "_compute");
    }
};

class IntervalsTest : public testing::TestWithParam<Form> {
  protected:
    std::vector<Interval> find(const LineSet& lines, const Camera& camera,
                               FrameOptions options = {}) {
        options.forms.atlas = GetParam().atlas;
        options.intervals = KeptIntervals::all;
        renderer_.set_lines(lines);
        gl::Canvas canvas{camera.size};
        renderer_.draw(camera, options, canvas.framebuffer());
        return renderer_.read_intervals();
    }

    /// Expects that the line behind a sheet ends at the sheet's sides.
    void expect_ends(const FrameOptions& options, int pieces, float lean, float limit);

    gl::HeadlessContext context_;
    Renderer renderer_{DeviceOptions{.compute = GetParam().compute}};
};

/// A line from left to right behind a sheet whose sides lean by `lean` pixels per pixel of height.
LineSet line_behind_sheet(float left, float right, float lean, int pieces) {
    Mesh mesh;
    mesh.positions = {{left - 50 * lean, 150, 50},
                      {right - 50 * lean, 150, 50},
                      {right + 50 * lean, 250, 50},
                      {left + 50 * lean, 250, 50}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    std::vector<std::uint32_t> line;
    for (int i = 0; i <= pieces; ++i) {
        line.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.emplace_back(20 + 360 * static_cast<float>(i) / static_cast<float>(pieces),
                                    200, 0);
    }
    mesh.polylines = {line};
    return extract_lines(mesh);
}

/// The values of x where the visibility of the file's line changes, from left to right.
std::vector<float> changes(const LineSet& lines, const std::vector<Interval>& intervals) {
    std::vector<float> result;
    const Interval* before = nullptr;
    for (const Interval& interval : intervals) {
        if ((lines.segments[interval.segment].tag & LA_TAG_KIND_MASK) != LA_KIND_FILE) continue;
        if (before != nullptr && is_visible(*before) != is_visible(interval)) {
            EXPECT_EQ(end_of(*before).x, start_of(interval).x);
            result.push_back(interval.start[0]);
        }
        before = &interval;
    }
    return result;
}

// Errors are measured across the edge that hides the line, because the depth buffer itself knows a
// slanted edge only to half a texel's diagonal.
TEST_P(IntervalsTest, EndsLieWhereTheSheetBegins) {
    for (const int depth_scale : {2, 4}) {
        FrameOptions options;
        options.depth_scale = depth_scale;
        // The pieces of the line are long, end where visibility changes, or are shorter than a
        // pixel.
        for (const int pieces : {1, 7, 90, 700}) {
            for (const float lean : {0.0F, 0.5F, -1.0F, 2.0F}) {
                expect_ends(options, pieces, lean, 0.7072F / static_cast<float>(depth_scale));
            }
        }
    }
}

void IntervalsTest::expect_ends(const FrameOptions& options, int pieces, float lean, float limit) {
    SCOPED_TRACE(testing::Message() << "depth scale " << options.depth_scale << ", " << pieces
                                    << " pieces, lean " << lean);
    const float across = 1 / std::sqrt(1 + lean * lean);
    for (const float shift : {0.0F, 0.3F, 0.7F, 1.1F, 1.6F}) {
        const float left = 121.3F + shift;
        const float right = 260.9F - 0.7F * shift;
        const LineSet lines = line_behind_sheet(left, right, lean, pieces);
        const std::vector<float> seen = changes(lines, find(lines, pixel_camera(), options));
        ASSERT_EQ(seen.size(), 2U);
        EXPECT_NEAR(seen[0] * across, left * across, limit);
        EXPECT_NEAR(seen[1] * across, right * across, limit);
    }
}

/// Expects that arc lengths add up, that neighbours meet, and that ends are points of the model.
void expect_whole(const LineSet& lines, const Camera& camera,
                  const std::vector<Interval>& intervals) {
    std::size_t visible = 0;
    const glm::mat4 clip_from_world = camera.clip_from_world();
    for (std::size_t i = 0; i < intervals.size(); ++i) {
        const Interval& interval = intervals[i];
        if (is_visible(interval)) ++visible;
        const Segment& segment = lines.segments[interval.segment];
        const bool first = i == 0 || intervals[i - 1].segment != interval.segment;
        const bool last = i + 1 == intervals.size() || intervals[i + 1].segment != interval.segment;
        if (first) {
            ASSERT_EQ(interval.start_sample, 0) << i;
        } else {
            ASSERT_LT(intervals[i - 1].segment, interval.segment + 1);
            ASSERT_EQ(interval.start_sample, intervals[i - 1].end_sample) << i;
            ASSERT_EQ(start_of(interval), end_of(intervals[i - 1])) << i;
            ASSERT_NE(is_visible(interval), is_visible(intervals[i - 1])) << i;
        }
        if (last) {
            ASSERT_EQ(interval.end_sample, std::round(interval.end_sample));
        }
        const glm::vec3 world{interval.start_world[0], interval.start_world[1],
                              interval.start_world[2]};
        const glm::vec4 clip = clip_from_world * glm::vec4{world, 1};
        const glm::vec2 window = (glm::vec2{clip} / clip.w + 1.0F) * 0.5F * glm::vec2{camera.size};
        ASSERT_LT(glm::distance(window, start_of(interval)), 0.02F) << i;
        const glm::vec3 p = lines.vertices[segment.p];
        const glm::vec3 q = lines.vertices[segment.q];
        const float along = glm::distance(p, world) + glm::distance(world, q);
        ASSERT_LE(along, glm::distance(p, q) * 1.0001F + 1e-4F) << i;
        ASSERT_GE(interval.alpha, 0);
        ASSERT_LE(interval.alpha, 1);
    }
    EXPECT_GT(visible, 0U);
    EXPECT_LT(visible, intervals.size());
}

TEST_P(IntervalsTest, VisibleAndHiddenAreTheWholeOfEveryLine) {
    for (const char* scene : {"clevis", "house"}) {
        const LineSet& lines = scene_lines(scene);
        for (const NamedCamera& view : scene_cameras(scene)) {
            SCOPED_TRACE(std::string{scene} + " " + view.name);
            FrameOptions options;
            options.cull_hidden = false;
            const std::vector<Interval> whole = find(lines, view.camera, options);
            expect_whole(lines, view.camera, whole);
            // Segments that are known to be hidden are not missing either.
            options.cull_hidden = true;
            const std::vector<Interval> culled = find(lines, view.camera, options);
            std::map<std::uint32_t, float> lengths;
            for (const Interval& interval : whole) lengths[interval.segment] += length_of(interval);
            for (const Interval& interval : culled)
                lengths[interval.segment] -= length_of(interval);
            for (const auto& [segment, difference] : lengths) {
                ASSERT_NEAR(difference, 0, 0.01) << segment;
            }
        }
    }
}

// Beside a smooth silhouette the surface folds away over half of a probe's reach.
TEST_P(IntervalsTest, TheOutlineOfABallIsVisibleAllAround) {
    const Mesh ball = sphere(5);
    const LineSet lines = extract_lines(ball);
    const glm::ivec2 size{400, 300};
    const Camera camera = make_camera(frame_points(lines.vertices, size), size, lines.bounds);
    double visible = 0, hidden = 0;
    for (const Interval& interval : find(lines, camera)) {
        (is_visible(interval) ? visible : hidden) += length_of(interval);
    }
    EXPECT_GT(visible, 600);
    EXPECT_LT(hidden, 0.01 * visible);
}

TEST_P(IntervalsTest, AFrameNeedNotBeDrawn) {
    const LineSet& lines = scene_lines("clevis");
    const Camera camera = scene_cameras("clevis")[0].camera;
    const std::vector<Interval> drawn = find(lines, camera);
    for (int frame = 0; frame < 3; ++frame) {
        gl::Canvas canvas{camera.size};
        canvas.clear({0.5F, 0.5F, 0.5F, 1});
        const std::vector<std::uint8_t> before = canvas.read();
        FrameOptions options;
        options.forms.atlas = GetParam().atlas;
        options.intervals = KeptIntervals::visible;
        options.draw = false;
        options.steady = false;
        renderer_.draw(camera, options, canvas.framebuffer());
        EXPECT_EQ(canvas.read(), before);
        const std::vector<Interval> seen = renderer_.read_intervals();
        EXPECT_EQ(static_cast<std::ptrdiff_t>(seen.size()),
                  std::ranges::count_if(drawn, is_visible));
    }
}

TEST_P(IntervalsTest, IntervalsThatWereNotKeptCannotBeRead) {
    const LineSet& lines = scene_lines("clevis");
    const Camera camera = scene_cameras("clevis")[0].camera;
    renderer_.set_lines(lines);
    EXPECT_THROW(renderer_.read_intervals(), UsageError);
    gl::Canvas canvas{camera.size};
    FrameOptions options;
    renderer_.draw(camera, options, canvas.framebuffer());
    EXPECT_THROW(renderer_.read_intervals(), UsageError);
    options.method = Method::spine;
    options.intervals = KeptIntervals::all;
    EXPECT_THROW(renderer_.draw(camera, options, canvas.framebuffer()), UsageError);
}

INSTANTIATE_TEST_SUITE_P(Forms, IntervalsTest,
                         testing::Values(Form{"opencl", StageForm::compute},
                                         Form{"opencl", StageForm::raster},
                                         Form{"cpp", StageForm::compute}),
                         [](const auto& info) { return info.param.name(); });

} // namespace
} // namespace lineatlas::test
