// Ridges and valleys as lines of a surface. Rays and the exact method find the same visible parts.

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "lineatlas/visibility.hpp"
#include "truth/edge_truth.hpp"
#include "waves.hpp"

namespace lineatlas {
namespace {

/// Visible pixels of ridges and of valleys.
struct Pixels {
    double ridges = 0, valleys = 0;

    void add(const LineSet& lines, std::uint32_t segment, double pixels) {
        const std::uint32_t kind = lines.segments[segment].tag & LA_TAG_KIND_MASK;
        if (kind == LA_KIND_RIDGE) ridges += pixels;
        if (kind == LA_KIND_VALLEY) valleys += pixels;
    }
};

Pixels by_rays(const RayScene& scene, const Camera& camera) {
    Pixels pixels;
    const EdgeTruth truth{scene, camera};
    for (const EdgePoint& point : truth.points())
        if (point.visibility == Visibility::visible)
            pixels.add(scene.lines(), point.segment, static_cast<double>(point.pixels));
    return pixels;
}

Pixels by_method(const LineSet& lines, const Camera& camera) {
    Pixels pixels;
    for (const Interval& one : LineVisibility{lines}.find(camera))
        pixels.add(
            lines, one.segment,
            std::hypot(double{one.end[0] - one.start[0]}, double{one.end[1] - one.start[1]}));
    return pixels;
}

/// A camera that looks across the crests, this many degrees above their plane.
Camera camera_above(const LineSet& lines, float degrees) {
    const float angle = degrees * std::numbers::pi_v<float> / 180;
    const glm::vec3 target{test::wave, 0, 6};
    const glm::vec3 eye = target + 60.0F * glm::vec3{-std::cos(angle), std::sin(angle), 0};
    return make_camera({.eye = eye, .target = target, .up = {0, 0, 1}}, {800, 600}, lines.bounds);
}

/// Without creases, because near a crease there is no ridge.
class RidgeTruth : public testing::Test {
  protected:
    LineSet lines_ = extract_lines(test::Waves{}.mesh(),
                                   {.lines = LA_KINDS_OF_SHAPE | mask_of(LineKind::silhouette)});
    RayScene scene_{lines_};
};

TEST_F(RidgeTruth, RaysAndTheExactMethodAgree) {
    for (const float degrees : {85.0F, 60.0F, 40.0F}) {
        const Camera camera = camera_above(lines_, degrees);
        const Pixels truth = by_rays(scene_, camera), found = by_method(lines_, camera);
        EXPECT_GT(truth.ridges, 100) << degrees;
        EXPECT_NEAR(found.ridges, truth.ridges, 0.01 * truth.ridges) << degrees;
        EXPECT_NEAR(found.valleys, truth.valleys, 0.01 * truth.valleys + 2) << degrees;
    }
}

TEST_F(RidgeTruth, CrestsHideFurrows) {
    EXPECT_GT(by_method(lines_, camera_above(lines_, 85)).valleys, 100);
    EXPECT_EQ(by_method(lines_, camera_above(lines_, 40)).valleys, 0);
}

TEST_F(RidgeTruth, NoRidgeRunsBesideAnOutline) {
    const Camera camera = camera_above(lines_, 20);
    EXPECT_LT(by_method(lines_, camera).ridges, 5);
    EXPECT_LT(by_rays(scene_, camera).ridges, 5);
}

} // namespace
} // namespace lineatlas
