// Visibility averaged over frames: less noise in slow motion, nothing else.

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

class Temporal : public testing::Test {
  protected:
    /// The scene seen from its path's start, with the picture moved aside by so many pixels.
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
    /// Mean change of visibility from frame to frame while the picture moves aside.
    double mean_change(bool steady) {
        Renderer r = renderer();
        Renderer::Samples before = draw(r, camera(0), steady);
        double sum = 0, count = 0;
        for (int i = 1; i <= 12; ++i) {
            const Renderer::Samples now = draw(r, camera(0.37 * i), steady);
            if (now.offsets == before.offsets) { // the picture only moves: samples are the same
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

TEST_F(Temporal, HalvesWhatChangesInSlowMotion) {
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
    for (int i = 0; i < 12; ++i) settled = draw(r, camera(0), true);
    Renderer fresh = renderer();
    const Renderer::Samples still = draw(fresh, camera(0), false);
    EXPECT_EQ(compare_bytes(settled.alpha, still.alpha, 2).beyond, 0U);
}

} // namespace
} // namespace lineatlas::test
