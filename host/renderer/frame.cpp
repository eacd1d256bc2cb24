#include "frame.hpp"

#include <cmath>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

// A surface hides a line if it stands before it by more than this many pixel widths: the line's own
// neighbourhood, a curved surface or a third face at a corner, must not.
constexpr float depth_tolerance_pixels = 1.0F;

/// Window depth that one pixel's width is worth, in the direction of sight, times w.
float depth_per_pixel(const Camera& camera) {
    const glm::mat4& p = camera.projection;
    const bool perspective = std::abs(p[2][3]) > 0;
    const float depth_rate = perspective ? p[3][2] : p[2][2];
    return std::abs(depth_rate / (p[1][1] * static_cast<float>(camera.size.y)));
}

} // namespace

std::uint32_t Frame::probes_per_axis() const {
    const auto root = static_cast<std::uint32_t>(std::lround(std::sqrt(options.probes)));
    if (root < 1 || root > 4 || root * root != options.probes) {
        throw UsageError("probes must be 1, 4, 9 or 16, not " + std::to_string(options.probes));
    }
    return root;
}

float Frame::depth_tolerance() const { return depth_tolerance_pixels * depth_per_pixel(camera); }

} // namespace lineatlas
