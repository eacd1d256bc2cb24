#include "depth_tolerance.hpp"

#include <cmath>

namespace lineatlas {
namespace {

// A surface hides a line if it stands before it by more than this many pixel widths: the line's own
// neighbourhood, a curved surface or a third face at a corner, must not. Two pixels along the ray
// is what bench/quality takes for the truth; along the view axis, as measured here, that is a
// little less.
constexpr float depth_tolerance_pixels = 1.9F;

/// Window depth that one pixel's width is worth, in the direction of sight, times w.
float depth_per_pixel(const Camera& camera) {
    const glm::mat4& p = camera.projection;
    const bool perspective = std::abs(p[2][3]) > 0;
    const float depth_rate = perspective ? p[3][2] : p[2][2];
    return std::abs(depth_rate / (p[1][1] * static_cast<float>(camera.size.y)));
}

} // namespace

float depth_tolerance(const Camera& camera) {
    return depth_tolerance_pixels * depth_per_pixel(camera);
}

} // namespace lineatlas
