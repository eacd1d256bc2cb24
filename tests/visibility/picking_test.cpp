// Picking at a point of a picture. The answers for cubes are known; those for scenes come from
// their intervals.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/visibility.hpp"
#include "scene_cameras.hpp"
#include "test_meshes.hpp"

namespace lineatlas::test {
namespace {

/// A cube, and behind it one of half its size, which shows to the right of it: objects 0 and 1.
Mesh two_cubes() {
    Mesh mesh = cube();
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    const std::size_t triangles = mesh.triangles.size();
    for (std::uint32_t i = 0; i < count; ++i)
        mesh.positions.push_back(0.5F * mesh.positions[i] + glm::vec3{1, 0, -4});
    for (std::size_t i = 0; i < triangles; ++i) mesh.triangles.push_back(mesh.triangles[i] + count);
    mesh.triangle_object.assign(triangles, 0);
    mesh.triangle_object.resize(2 * triangles, 1);
    return mesh;
}

const LineSet& two() {
    static const LineSet lines = extract_lines(two_cubes(), {.separate_objects = true});
    return lines;
}

/// A parallel view along -z with 100 pixels to a unit. The origin is at (200, 200).
Camera straight(const LineSet& lines) {
    View view{.eye = {0, 0, 10}, .projection = Projection::orthographic};
    return make_camera(with_shown_height(view, 4), {400, 400}, lines.bounds);
}

void expect_near(glm::vec3 a, glm::vec3 b, float by) {
    EXPECT_LT(glm::distance(a, b), by) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Picking, FindsTheEdgeThatIsNear) {
    LineVisibility visibility{two()};
    const std::optional<Pick> found = visibility.pick(straight(two()), {302, 210}, 4);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kind, LineKind::crease);
    EXPECT_EQ(found->triangle, Pick::none);
    EXPECT_EQ(found->object, 0U);
    EXPECT_NEAR(found->distance, 2, 1e-3F);
    EXPECT_LT(glm::distance(found->position, glm::vec2{300, 210}), 1e-3F);
    expect_near(found->world, {1, 0.1F, 1}, 1e-5F); // not the edge behind it at z = -1
    ASSERT_LT(found->segment, two().sources.size());
    const LineSource& edge = two().sources[found->segment];
    const Mesh mesh = two_cubes();
    for (const std::uint32_t end : {edge.from, edge.to}) {
        EXPECT_EQ(mesh.positions[end].x, 1);
        EXPECT_EQ(mesh.positions[end].z, 1);
    }
}

TEST(Picking, FindsTheFaceWhereNoLineIsNear) {
    LineVisibility visibility{two()};
    const Camera camera = straight(two());
    const std::optional<Pick> face = visibility.pick(camera, {230, 190}, 4);
    ASSERT_TRUE(face);
    EXPECT_EQ(face->segment, Pick::none);
    EXPECT_FALSE(face->kind);
    EXPECT_EQ(face->object, 0U);
    EXPECT_EQ(face->distance, 0);
    expect_near(face->world, {0.3F, -0.1F, 1}, 1e-5F);
    const Mesh mesh = two_cubes();
    ASSERT_LT(face->triangle, two().triangle_sources.size());
    const glm::uvec3 corners = mesh.triangles[two().triangle_sources[face->triangle]];
    for (int i = 0; i < 3; ++i) EXPECT_EQ(mesh.positions[corners[i]].z, 1);
    // The other cube, right of the first.
    const std::optional<Pick> behind = visibility.pick(camera, {325, 210}, 4);
    ASSERT_TRUE(behind);
    EXPECT_EQ(behind->object, 1U);
    expect_near(behind->world, {1.25F, 0.1F, -3.5F}, 1e-5F);
    EXPECT_FALSE(visibility.pick(camera, {20, 30}, 4)) << "paper";
    EXPECT_FALSE(visibility.pick(camera, {-50, 200}, 4)) << "outside";
}

TEST(Picking, ALineThatIsHiddenIsNotThere) {
    LineVisibility visibility{two()};
    const Camera camera = straight(two());
    // The left edge of the small cube, at x = 0.5, is behind the large one.
    const std::optional<Pick> found = visibility.pick(camera, {250, 210}, 3);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->segment, Pick::none);
    LineSet alone = two();
    const std::uint32_t first[] = {0};
    hide_objects(alone, first);
    visibility.set_lines(alone);
    const std::optional<Pick> shown = visibility.pick(camera, {250, 210}, 3);
    ASSERT_TRUE(shown);
    ASSERT_NE(shown->segment, Pick::none);
    EXPECT_EQ(shown->object, 1U);
    expect_near(shown->world, {0.5F, 0.1F, -3.5F}, 1e-5F);
}

TEST(Picking, OfKindsThatAreWanted) {
    LineVisibility visibility{two()};
    const std::optional<Pick> found =
        visibility.pick(straight(two()), {298, 210}, 4, mask_of(LineKind::boundary));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->segment, Pick::none);
}

float distance_to(const Interval& interval, glm::vec2 point) {
    const glm::vec2 start{interval.start[0], interval.start[1]};
    const glm::vec2 way = glm::vec2{interval.end[0], interval.end[1]} - start;
    const float share =
        glm::clamp(glm::dot(point - start, way) / std::max(glm::dot(way, way), 1e-12F), 0.0F, 1.0F);
    return glm::distance(start + share * way, point);
}

TEST(Picking, AgreesWithTheIntervalsOfTheWholePicture) {
    Random random{7};
    for (const char* name : {"clevis", "house"}) {
        const LineSet& lines = scene_lines(name);
        LineVisibility visibility{lines};
        for (const NamedCamera& view : scene_cameras(name, {640, 480})) {
            const Camera& camera = view.camera;
            const std::vector<Interval> all = visibility.find(camera, {.step = 0.01F});
            std::size_t found_lines = 0;
            for (int i = 0; i < 40; ++i) {
                const glm::vec2 point{random.between(0, 640), random.between(0, 480)};
                float nearest = std::numeric_limits<float>::infinity();
                for (const Interval& one : all)
                    nearest = std::min(nearest, distance_to(one, point));
                constexpr float radius = 12;
                const std::optional<Pick> found = visibility.pick(camera, point, radius);
                const bool is_line = found && found->segment != Pick::none;
                // Ends of visible parts are exact to some hundredths of a pixel.
                if (std::abs(nearest - radius) < 0.1F) continue;
                ASSERT_EQ(is_line, nearest < radius) << name << ' ' << point.x << ' ' << point.y;
                if (!found) continue;
                const glm::vec4 clip = camera.clip_from_world() * glm::vec4{found->world, 1};
                const glm::vec2 seen =
                    (glm::vec2{clip} / clip.w + 1.0F) * 0.5F * glm::vec2{camera.size};
                EXPECT_LT(glm::distance(seen, found->position), 0.05F);
                if (!is_line) continue;
                ++found_lines;
                EXPECT_NEAR(found->distance, nearest, 0.1F);
                EXPECT_NEAR(glm::distance(found->position, point), found->distance, 1e-2F);
            }
            EXPECT_GT(found_lines, 3U) << name;
        }
    }
}

TEST(Picking, RefusesWhatMakesNoSense) {
    LineVisibility visibility{two()};
    const Camera camera = straight(two());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(visibility.pick(camera, {nan, 0}, 4), UsageError);
    EXPECT_THROW(visibility.pick(camera, {0, 0}, -1), UsageError);
    EXPECT_THROW(visibility.pick(camera, {0, 0}, 1001), UsageError);
    EXPECT_THROW(visibility.pick(camera, {0, 0}, nan), UsageError);
    EXPECT_TRUE(visibility.pick(camera, {302, 210}, 4)) << "works on";
}

TEST(PickingOfARenderer, IsOfTheLastFrameWhateverItsMethod) {
    const gl::HeadlessContext context;
    gl::Canvas canvas{{400, 400}};
    Renderer renderer{{.compute = "cpp"}};
    EXPECT_THROW(renderer.pick({0, 0}, 4), UsageError);
    renderer.set_lines(two());
    EXPECT_THROW(renderer.pick({0, 0}, 4), UsageError);
    for (const Method method :
         {Method::atlas, Method::exact, Method::spine, Method::item_buffer, Method::opengl}) {
        renderer.draw(straight(two()), {.method = method}, canvas.framebuffer());
        const std::optional<Pick> found = renderer.pick({302, 210}, 4);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->kind, LineKind::crease);
        expect_near(found->world, {1, 0.1F, 1}, 1e-5F);
    }
    renderer.draw(straight(two()), {.lines = mask_of(LineKind::silhouette)}, canvas.framebuffer());
    const std::optional<Pick> other = renderer.pick({302, 210}, 4);
    ASSERT_TRUE(other);
    EXPECT_EQ(other->segment, Pick::none) << "of what is not drawn";
}

TEST(PickingOfARenderer, LeavesTheFrameToBeRead) {
    const gl::HeadlessContext context;
    gl::Canvas canvas{{400, 400}};
    Renderer renderer{{.compute = "cpp"}};
    renderer.set_lines(two());
    for (const Method method : {Method::atlas, Method::exact}) {
        renderer.draw(straight(two()), {.method = method, .intervals = KeptIntervals::visible},
                      canvas.framebuffer());
        const std::size_t before = renderer.read_intervals().size();
        renderer.pick({302, 210}, 4);
        EXPECT_EQ(renderer.read_intervals().size(), before);
    }
}

TEST(PickingOfARenderer, FollowsWhatMovesAndWhatIsHidden) {
    const gl::HeadlessContext context;
    gl::Canvas canvas{{400, 400}};
    Renderer renderer{{.compute = "cpp"}};
    renderer.set_lines(two());
    const Camera camera = straight(two());
    std::vector<glm::mat4> transforms(2, glm::mat4{1});
    transforms[0] = glm::translate(glm::mat4{1}, {-0.5F, 0, 0});
    renderer.set_transforms(transforms);
    renderer.draw(camera, {}, canvas.framebuffer());
    const std::optional<Pick> moved = renderer.pick({251, 210}, 4);
    ASSERT_TRUE(moved);
    EXPECT_EQ(moved->object, 0U);
    expect_near(moved->world, {0.5F, 0.1F, 1}, 1e-5F);
    const std::uint32_t hidden[] = {0};
    renderer.set_hidden(hidden);
    renderer.draw(camera, {}, canvas.framebuffer());
    const std::optional<Pick> shown = renderer.pick({251, 210}, 4);
    ASSERT_TRUE(shown);
    EXPECT_EQ(shown->object, 1U);
    expect_near(shown->world, {0.5F, 0.1F, -3.5F}, 1e-5F);
    const std::optional<Pick> face = renderer.pick(camera, {300, 210}, 4);
    ASSERT_TRUE(face);
    EXPECT_EQ(face->object, 1U);
    EXPECT_NE(face->triangle, Pick::none);
    EXPECT_FALSE(renderer.pick({150, 200}, 4)) << "the hidden cube's face";
}

} // namespace
} // namespace lineatlas::test
