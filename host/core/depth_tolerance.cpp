#include "depth_tolerance.hpp"

#include <cmath>

namespace lineatlas {
namespace {

// A surface hides a line if the surface stands before the line by more than this many pixel widths.
// The line's own surroundings, such as a curved surface or a third face at a corner, must not hide
// the line. The truth of bench/quality takes two pixels along the ray. Along the view axis, as
// measured here, that is a little less.
constexpr float depth_tolerance_pixels = 1.9F;

/// The window depth of one pixel's width in the direction of sight, times w.
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
