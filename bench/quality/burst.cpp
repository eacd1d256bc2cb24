#include "burst.hpp"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

namespace lineatlas::bench {
namespace {

constexpr double most_motion = 0.9; // pixels
constexpr double quantile = 0.95;
constexpr std::size_t most_points = 20'000; // enough for a quantile

std::vector<glm::dvec3> visible_points(const LineSet& set, const ClippedLines& lines,
                                       const std::vector<float>& truth) {
    std::vector<glm::dvec3> points;
    for (std::uint32_t i = 0; i < set.segments.size(); ++i) {
        const std::uint32_t l = lines.samples(i);
        const ClippedSegment& clipped = lines.clipped[i];
        const glm::dvec3 p{set.vertices[set.segments[i].p]};
        const glm::dvec3 q{set.vertices[set.segments[i].q]};
        for (std::uint32_t j = 0; j < l; ++j) {
            if (truth[lines.offsets[i] + j] < 0.5F) continue;
            points.push_back(p + (q - p) * parameter_at(clipped, (j + 0.5) / l));
        }
    }
    if (points.size() <= most_points) return points;
    std::vector<glm::dvec3> some;
    const std::size_t stride = points.size() / most_points + 1;
    for (std::size_t i = 0; i < points.size(); i += stride) some.push_back(points[i]);
    return some;
}

glm::dvec2 window_position(const glm::dmat4& clip_from_world, glm::dvec3 point, glm::dvec2 size) {
    const glm::dvec4 clip = clip_from_world * glm::dvec4{point, 1};
    return glm::dvec2{clip} / clip.w * size * 0.5;
}

glm::dmat4 exact_matrix(const Camera& camera) {
    return glm::dmat4{camera.projection} * glm::dmat4{camera.view};
}

/// How far each point moves on the screen, sorted.
std::vector<double> motions(const std::vector<glm::dvec3>& points, const Camera& from,
                            const Camera& to) {
    std::vector<double> result;
    result.reserve(points.size());
    const glm::dvec2 size{from.size};
    const glm::dmat4 a = exact_matrix(from), b = exact_matrix(to);
    for (const glm::dvec3& point : points) {
        result.push_back(
            glm::distance(window_position(a, point, size), window_position(b, point, size)));
    }
    std::ranges::sort(result);
    return result;
}

} // namespace

Burst slow_burst(const PathView& view, const LineSet& set, glm::ivec2 size, std::size_t count,
                 const ClippedLines& lines, const std::vector<float>& truth) {
    const auto camera_at = [&](double t) { return make_camera(view.path(t), size, set.bounds); };
    Burst burst{{camera_at(view.at)}, 0};
    if (count < 2) return burst;
    const std::vector<glm::dvec3> points = visible_points(set, lines, truth);
    double step =
        view.at < 0.5 ? 1e-4 : -1e-4; // forwards or backwards, so that it stays within the path
    for (int round = 0; round < 3 && !points.empty(); ++round) {
        const std::vector<double> sorted =
            motions(points, burst.cameras[0], camera_at(view.at + step));
        const double reached =
            sorted[static_cast<std::size_t>(quantile * static_cast<double>(sorted.size() - 1))];
        if (reached > 0) step *= most_motion / reached;
    }
    for (std::size_t i = 1; i < count; ++i) {
        burst.cameras.push_back(camera_at(view.at + step * static_cast<double>(i)));
    }
    if (!points.empty()) {
        const auto sorted = motions(points, burst.cameras[0], burst.cameras[1]);
        burst.typical_motion = sorted[sorted.size() / 2];
    }
    return burst;
}

} // namespace lineatlas::bench
