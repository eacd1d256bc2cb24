#include "edge_truth.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <thread>

#include <glm/geometric.hpp>

#include "contour_crossing.hpp"
#include "shared/constants.h"

namespace lineatlas {
namespace {

/// The cosine between sight and face below which single precision cannot tell front from back.
constexpr double edge_on = 1e-4;
/// How far, in pixels, rays for a silhouette pass beyond a smooth surface. It is farther than
/// triangles reach beyond their surface.
constexpr double beyond = 0.1;

bool is_candidate(const Segment& segment) {
    return (segment.tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE;
}

/// Cosine between a triangle's normal and the way from it to the eye: positive in front.
double facing(const LineSet& lines, const PreciseCamera& projection, std::uint32_t triangle) {
    const glm::uvec3 t = lines.triangles[triangle];
    const glm::dvec3 a{lines.vertices[t.x]}, b{lines.vertices[t.y]}, c{lines.vertices[t.z]};
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const glm::dvec3 toward = projection.start_of_sight(a) - a;
    const double size = glm::length(normal) * glm::length(toward);
    return size > 0 ? glm::dot(normal, toward) / size : 0;
}

/// The sine between sight and surface in the middle of a segment. The surface is a mean of
/// triangles along the path, as in `project_clip` for ridges.
double ridge_facing(const LineSet& lines, const PreciseCamera& projection, std::size_t index) {
    const Segment& segment = lines.segments[index];
    glm::dvec3 normal{0};
    const std::size_t last = index + std::min(segment.to_end, LA_GRAZING_STEPS);
    for (std::size_t i = index - std::min(segment.from_start, LA_GRAZING_STEPS); i <= last; ++i) {
        const glm::uvec3 t = lines.triangles[lines.segments[i].face_a];
        const glm::dvec3 a{lines.vertices[t.x]}, b{lines.vertices[t.y]}, c{lines.vertices[t.z]};
        normal += glm::cross(b - a, c - a);
    }
    const glm::dvec3 middle =
        0.5 * (glm::dvec3{lines.vertices[segment.p]} + glm::dvec3{lines.vertices[segment.q]});
    const glm::dvec3 toward = projection.start_of_sight(middle) - middle;
    const double size = glm::length(normal) * glm::length(toward);
    return size > 0 ? std::abs(glm::dot(normal, toward)) / size : 0;
}

enum class Drawn { never, perhaps, surely };

/// Whether a segment is a line of the picture, hidden or not.
Drawn is_drawn(const LineSet& lines, const PreciseCamera& projection, std::size_t index) {
    const Segment& segment = lines.segments[index];
    if ((segment.tag & LA_TAG_KIND_MASK) == LA_KIND_RIDGE) {
        const double above = ridge_facing(lines, projection, index) - double{LA_GRAZING};
        return above > edge_on ? Drawn::surely : above < -edge_on ? Drawn::never : Drawn::perhaps;
    }
    // Centre lines hang over their ends and go on where they are hidden, so visibility does not
    // matter.
    if ((segment.tag & LA_TAG_KIND_MASK) == LA_KIND_CENTRE) return Drawn::never;
    if (!is_candidate(segment)) return Drawn::surely;
    const double a = facing(lines, projection, segment.face_a);
    double b = facing(lines, projection, segment.face_b & LA_FACE_INDEX);
    if ((segment.face_b & LA_FACE_FLIPPED) != 0) b = -b;
    if (std::min(std::abs(a), std::abs(b)) < edge_on) return Drawn::perhaps;
    return (a > 0) != (b > 0) ? Drawn::surely : Drawn::never;
}

/// Triangles that share a corner with one that touches the segment, sorted.
std::vector<std::uint32_t> two_rings(const RayScene& scene, const Segment& segment) {
    std::vector<std::uint32_t> corners{segment.p, segment.q};
    if (scene.triangles_at(segment.p).empty() || scene.triangles_at(segment.q).empty()) {
        for (const std::uint32_t face : {segment.face_a, segment.face_b}) {
            if (face == LA_NO_FACE) continue;
            const glm::uvec3 t = scene.lines().triangles[face & LA_FACE_INDEX];
            corners.insert(corners.end(), {t.x, t.y, t.z});
        }
    }
    std::vector<std::uint32_t> triangles;
    for (int ring = 0; ring < 2; ++ring) {
        triangles.clear();
        for (const std::uint32_t corner : corners)
            std::ranges::copy(scene.triangles_at(corner), std::back_inserter(triangles));
        std::ranges::sort(triangles);
        triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
        corners.clear();
        for (const std::uint32_t triangle : triangles) {
            const glm::uvec3 t = scene.lines().triangles[triangle];
            corners.insert(corners.end(), {t.x, t.y, t.z});
        }
        std::ranges::sort(corners);
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    }
    return triangles;
}

/// The points of one segment.
class Sampler {
  public:
    Sampler(const RayScene& scene, const PreciseCamera& projection, const EdgeTruthOptions& options,
            std::uint32_t index)
        : scene_(scene), projection_(projection), options_(options), index_(index),
          segment_(scene.lines().segments[index]) {}

    void append_to(std::vector<EdgePoint>& points) const {
        const Contours& contours = scene_.lines().contours;
        const std::size_t first = scene_.lines().segments.size() - contours.faces.size();
        if (index_ >= first)
            return append_contour(static_cast<std::uint32_t>(index_ - first), points);
        if (index_ < first - contours.replaced) append_edge(points);
    }

  private:
    void append_edge(std::vector<EdgePoint>& points) const {
        const LineSet& lines = scene_.lines();
        const Drawn drawn = is_drawn(lines, projection_, index_);
        if (drawn == Drawn::never) return;
        const glm::dvec3 p{lines.vertices[segment_.p]}, q{lines.vertices[segment_.q]};
        const std::optional<LinePart> part = part_inside(projection_, p, q);
        if (!part) return;
        const SeenLine line{projection_, p, q, part->t0, part->t1};
        const auto count =
            static_cast<std::size_t>(std::max(1.0, std::ceil(line.length() / options_.step)));
        std::vector<Sight> middle, sides;
        for (std::size_t i = 0; i < count; ++i) {
            const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
            middle.push_back(line.sight(u, 0));
            for (const double side : {-1.0, 1.0}) sides.push_back(line.sight(u, side));
        }
        const Blocking blocking{scene_, projection_, options_.rule, index_};
        const std::vector<std::uint8_t> hidden = cast(middle, [&](auto sight, auto triangle) {
            return blocking.before(middle[sight], triangle).has_value();
        });
        // Beside a visible line its own surface goes on and does not decide: its smooth patches,
        // and the nearest triangles.
        std::vector<std::uint32_t> rings;
        if (std::ranges::find(hidden, 0) != hidden.end()) rings = two_rings(scene_, segment_);
        const std::vector<std::uint8_t> beside = cast(sides, [&](auto sight, auto triangle) {
            if (hidden[sight / 2] == 0 &&
                (blocking.is_own_surface(triangle) || std::ranges::binary_search(rings, triangle)))
                return false;
            return blocking.before(sides[sight], triangle).has_value();
        });
        for (std::size_t i = 0; i < count; ++i) {
            const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
            const bool same = beside[2 * i] == hidden[i] && beside[2 * i + 1] == hidden[i];
            points.push_back(point(line, u, count,
                                   !same            ? Visibility::undecided
                                   : hidden[i] != 0 ? Visibility::hidden
                                                    : Visibility::visible,
                                   drawn == Drawn::surely));
            points.back().on_arc = on_arc(middle[i].spine);
        }
    }

    /// Where a place of a chord is on the circle that its mesh was cut from.
    std::optional<glm::vec2> on_arc(const glm::dvec3& place) const {
        const MeshCircles* const circles = options_.circles;
        const std::uint32_t number =
            circles != nullptr ? circles->circle_of(index_) : MeshCircles::none;
        if (number == MeshCircles::none) return {};
        const EdgeCurve& circle = circles->circle(number);
        const glm::dvec3 out = place - circle.center;
        const glm::dvec3 on = circle.center + glm::length(circle.u) / glm::length(out) * out;
        return glm::vec2{projection_.picture(projection_.clip_from_world * glm::dvec4{on, 1})};
    }

    /// Rays just beyond the surface decide, and a pixel to either side.
    void append_contour(std::uint32_t face, std::vector<EdgePoint>& points) const {
        const LineSet& lines = scene_.lines();
        const auto crossing = contour_crossing(lines, projection_, face);
        if (!crossing) return;
        const std::optional<LinePart> part = part_inside(projection_, crossing->from, crossing->to);
        if (!part) return;
        const SeenLine line{projection_, crossing->from, crossing->to, part->t0, part->t1};
        if (!(line.length() > 0)) return;
        const double side = line.is_left(crossing->beyond) ? 1 : -1;
        const Blocking blocking{scene_, projection_, options_.rule, index_};
        // If only triangles of the surface are known, they reach beyond it, by less than a side of
        // one.
        const double own_reach =
            crossing->on_known_surface ? 0 : longest_side(lines.triangles[segment_.face_a]);
        const auto count =
            static_cast<std::size_t>(std::max(1.0, std::ceil(line.length() / options_.step)));
        for (std::size_t i = 0; i < count; ++i) {
            const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
            const std::vector<Sight> sights{line.sight(u, side * beyond), line.sight(u, side),
                                            line.sight(u, -side)};
            const auto blocked = cast(sights, [&](auto sight, auto triangle) {
                const auto before = blocking.before(sights[sight], triangle);
                if (!before) return false;
                const bool own = blocking.is_own_surface(triangle);
                return !own || (sight < 2 && *before > own_reach);
            });
            // On the inner side another surface decides, never that of the silhouette.
            Visibility found = blocked[0] != 0 && blocked[1] != 0    ? Visibility::hidden
                               : std::ranges::count(blocked, 0) == 3 ? Visibility::visible
                                                                     : Visibility::undecided;
            if (!crossing->on_known_surface && !crossing->shows_front &&
                found == Visibility::visible)
                found = Visibility::undecided;
            points.push_back(point(line, u, count, found, true));
        }
    }

    EdgePoint point(const SeenLine& line, double u, std::size_t count, Visibility visibility,
                    bool required) const {
        return {.at = glm::vec2{line.at(u)},
                .along = glm::vec2{line.direction()},
                .pixels = static_cast<float>(line.length() / static_cast<double>(count)),
                .segment = index_,
                .u = static_cast<float>(u),
                .visibility = visibility,
                .required = required};
    }

    double longest_side(const glm::uvec3& triangle) const {
        double longest = 0;
        for (int k = 0; k < 3; ++k)
            longest = std::max(
                longest, glm::distance(glm::dvec3{scene_.lines().vertices[triangle[k]]},
                                       glm::dvec3{scene_.lines().vertices[triangle[(k + 1) % 3]]}));
        return longest;
    }

    std::vector<std::uint8_t> cast(const std::vector<Sight>& sights,
                                   const RayScene::Judge& judge) const {
        std::vector<std::uint8_t> blocked(sights.size());
        scene_.cast(sights, judge, blocked);
        return blocked;
    }

    const RayScene& scene_;
    const PreciseCamera& projection_;
    const EdgeTruthOptions& options_;
    std::uint32_t index_;
    const Segment& segment_;
};

} // namespace

EdgeTruth::EdgeTruth(const RayScene& scene, const Camera& camera, const EdgeTruthOptions& options)
    : size_(camera.size), scene_(scene), projection_(camera, scene.lines().bounds),
      rule_(options.rule) {
    constexpr std::uint32_t block = 256;
    const auto segments = static_cast<std::uint32_t>(scene.lines().segments.size());
    std::vector<std::vector<EdgePoint>> found((segments + block - 1) / block);
    std::atomic<std::uint32_t> next{0};
    const auto work = [&] {
        for (std::uint32_t i; (i = next.fetch_add(1)) < found.size();) {
            const std::uint32_t end = std::min(segments, (i + 1) * block);
            for (std::uint32_t segment = i * block; segment < end; ++segment)
                Sampler{scene_, projection_, options, segment}.append_to(found[i]);
        }
    };
    {
        std::vector<std::jthread> threads;
        for (unsigned i = 1; i < options.threads; ++i) threads.emplace_back(work);
        work();
    }
    first_.assign(segments + std::size_t{1}, 0);
    for (const std::vector<EdgePoint>& part : found) {
        for (const EdgePoint& point : part) ++first_[point.segment + 1];
        points_.insert(points_.end(), part.begin(), part.end());
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

std::span<const EdgePoint> EdgeTruth::points_of(std::uint32_t segment) const {
    return std::span{points_}.subspan(first_[segment], first_[segment + 1] - first_[segment]);
}

std::optional<EdgeTruth::Blocker> EdgeTruth::nearest_blocker(const EdgePoint& point) const {
    const LineSet& lines = scene_.lines();
    const Segment& segment = lines.segments[point.segment];
    const glm::dvec3 p{lines.vertices[segment.p]}, q{lines.vertices[segment.q]};
    const std::optional<LinePart> part = part_inside(projection_, p, q);
    if (!part) return std::nullopt;
    const std::array sight{
        SeenLine{projection_, p, q, part->t0, part->t1}.sight(double{point.u}, 0)};
    const Blocking blocking{scene_, projection_, rule_, point.segment};
    std::optional<Blocker> nearest;
    const RayScene::Judge note = [&](std::uint32_t, std::uint32_t triangle) {
        const std::optional<double> before = blocking.before(sight[0], triangle);
        if (before && (!nearest || *before / sight[0].pixel < nearest->distance))
            nearest = {*before / sight[0].pixel, triangle};
        return false; // all of them
    };
    std::array<std::uint8_t, 1> blocked{};
    scene_.cast(sight, note, blocked);
    return nearest;
}

} // namespace lineatlas
