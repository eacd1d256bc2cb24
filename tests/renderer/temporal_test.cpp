// Visibility averaged over frames has less noise in slow motion, and no other change.

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "scene_cameras.hpp"
#include "test_meshes.hpp"

namespace lineatlas::test {
namespace {

class Temporal : public testing::Test {
  protected:
    /// The camera at the start of the scene's path, with the picture moved to the side by `pixels`.
    Camera camera(double pixels) const {
        Camera result = make_camera(scene_.view(0), canvas_.size(), scene_lines("house").bounds);
        result.projection[2][0] += static_cast<float>(2 * pixels / canvas_.size().x);
        return result;
    }
    Renderer::Samples draw(Renderer& renderer, const Camera& camera, bool steady) {
        renderer.draw(camera, {.cull_hidden = false, .steady = steady}, canvas_.framebuffer());
        return renderer.read_samples();
    }
    Renderer renderer() {
        Renderer result;
        result.set_lines(scene_lines("house"));
        return result;
    }
    /// The mean change of visibility from frame to frame while the picture moves to the side.
    double mean_change(bool steady) {
        Renderer r = renderer();
        Renderer::Samples before = draw(r, camera(0), steady);
        double sum = 0, count = 0;
        for (int i = 1; i <= 12; ++i) {
            const Renderer::Samples now = draw(r, camera(0.37 * i), steady);
            if (now.offsets == before.offsets) { // the picture only moves, so samples are the same
                for (std::size_t j = 0; j < now.alpha.size(); ++j) {
                    sum += std::abs(int{now.alpha[j]} - int{before.alpha[j]});
                    ++count;
                }
            }
            before = now;
        }
        EXPECT_GT(count, 1e5) << "nothing was compared";
        return sum / count;
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{640, 480}};
    const Scene scene_ = make_scene("house");
};

TEST_F(Temporal, ReducesChangesInSlowMotionByTwoFifths) {
    const double plain = mean_change(false);
    EXPECT_GT(plain, 0.5);
    EXPECT_LT(mean_change(true), 0.6 * plain);
}

TEST_F(Temporal, LeavesAStillPictureAlone) {
    Renderer r = renderer();
    const Renderer::Samples first = draw(r, camera(0), true);
    const Renderer::Samples second = draw(r, camera(0), true);
    EXPECT_TRUE(equal(first.alpha, second.alpha));
    Renderer other = renderer();
    EXPECT_TRUE(equal(first.alpha, draw(other, camera(0), false).alpha));
}

TEST_F(Temporal, LeavesTheFirstFrameAfterAJumpAlone) {
    Renderer r = renderer();
    draw(r, camera(30), true);
    const Renderer::Samples jumped = draw(r, camera(0), true);
    Renderer fresh = renderer();
    EXPECT_TRUE(equal(jumped.alpha, draw(fresh, camera(0), false).alpha));
}

TEST_F(Temporal, ReachesTheStillPictureSoonAfterMotionEnds) {
    Renderer r = renderer();
    for (int i = 5; i >= 0; --i) draw(r, camera(0.3 * i), true);
    Renderer::Samples settled;
    // 0.78 to that power leaves less than 2 of LA_TEMPORAL_LARGEST_CHANGE.
    constexpr int frames = 18;
    for (int i = 0; i < frames; ++i) settled = draw(r, camera(0), true);
    Renderer fresh = renderer();
    const Renderer::Samples still = draw(fresh, camera(0), false);
    EXPECT_EQ(compare_bytes(settled.alpha, still.alpha, 2).beyond, 0U);
}

/// Tubes all over the picture. Each is an object, and many of them intersect.
LineSet tubes(int count) {
    Random random{7};
    Mesh all;
    for (int i = 0; i < count; ++i) {
        const glm::mat4 thin = glm::scale(random.placement(6), {0.3F, 1.5F, 0.3F});
        const Mesh tube = moved(cylinder(16, true), thin);
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), tube.positions.begin(), tube.positions.end());
        for (const glm::uvec3& triangle : tube.triangles) all.triangles.push_back(triangle + first);
        all.triangle_object.resize(all.triangles.size(), static_cast<std::uint32_t>(i));
    }
    return extract_lines(all, {.separate_objects = true});
}

/// Every tube turned about its middle a little, frame by frame.
std::vector<glm::mat4> turned(const LineSet& lines, float angle) {
    std::vector<glm::mat4> result;
    for (const LineObject& object : lines.objects) {
        glm::vec3 middle{0};
        for (std::uint32_t i = 0; i < object.vertex_count; ++i) {
            middle += lines.vertices[object.first_vertex + i];
        }
        middle /= static_cast<float>(object.vertex_count);
        const glm::mat4 there = glm::translate(glm::mat4{1}, middle);
        const float way = result.size() % 2 == 0 ? angle : -angle;
        result.push_back(there *
                         glm::rotate(glm::mat4{1}, way, glm::normalize(glm::vec3{1, 2, 3})) *
                         glm::translate(glm::mat4{1}, -middle));
    }
    return result;
}

TEST_F(Temporal, ObjectsThatMoveLeaveNoGhosts) {
    const LineSet lines = tubes(300);
    ASSERT_EQ(lines.objects.size(), 300U);
    const Camera camera = make_camera({.eye = {0, 0, 22}}, canvas_.size(), lines.bounds);
    std::vector<std::uint8_t> pictures[2];
    for (const bool steady : {false, true}) {
        Renderer renderer;
        renderer.set_lines(lines);
        for (int frame = 0; frame < 8; ++frame) {
            renderer.set_transforms(turned(lines, 0.02F * static_cast<float>(frame)));
            canvas_.clear(glm::vec4{1});
            renderer.draw(camera, {.steady = steady}, canvas_.framebuffer());
        }
        pictures[steady ? 1 : 0] = canvas_.read();
    }
    constexpr int white = 255, barely = 242; // 5 % darker
    int ghosts = 0, lines_drawn = 0;
    for (std::size_t i = 0; i < pictures[0].size(); i += 4) {
        lines_drawn += pictures[0][i] < 128 ? 1 : 0;
        if (pictures[0][i] == white && pictures[1][i] < barely) ++ghosts;
    }
    EXPECT_GT(lines_drawn, 5000);
    EXPECT_EQ(ghosts, 0);
    EXPECT_FALSE(equal(pictures[0], pictures[1])) << "nothing was averaged";
}

} // namespace
} // namespace lineatlas::test
