#include "picking.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "compute/transfer.hpp"
#include "core/picture_size.hpp"
#include "core/ray.hpp"
#include "core/tiles.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr float largest_radius = 1000;

/// The part of the picture that may hold something within the radius; empty beyond the picture.
PictureTile around(glm::vec2 position, float radius, glm::ivec2 size) {
    const glm::vec2 reach{radius + 1};
    const glm::vec2 most{size};
    const glm::ivec2 low{glm::floor(glm::clamp(position - reach, glm::vec2{0}, most))};
    const glm::ivec2 high{glm::ceil(glm::clamp(position + reach, glm::vec2{0}, most))};
    return {low, high - low};
}

/// The object that a vertex belongs to.
std::uint32_t object_of(std::span<const LineObject> objects, std::uint32_t vertex) {
    const auto found = std::ranges::find_if(objects, [vertex](const LineObject& object) {
        return vertex - object.first_vertex < object.vertex_count; // wraps around for a vertex
                                                                   // before the first
    });
    return found == objects.end() ? 0 : static_cast<std::uint32_t>(found - objects.begin());
}

/// The point of an interval that is nearest to a window position.
struct Nearest {
    float along = 0; ///< share of the way on the screen
    float distance = 0, depth = 0;
};

Nearest nearest_of(const Interval& interval, glm::vec2 position) {
    const glm::vec2 start{interval.start[0], interval.start[1]};
    const glm::vec2 way = glm::vec2{interval.end[0], interval.end[1]} - start;
    const float squared = glm::dot(way, way);
    const float along =
        squared > 0 ? glm::clamp(glm::dot(position - start, way) / squared, 0.0F, 1.0F) : 0.0F;
    return {along, glm::distance(start + along * way, position),
            glm::mix(interval.start_depth, interval.end_depth, along)};
}

/// The point of the model that is seen at a place of the interval. Halfway on the screen is not
/// halfway in space.
glm::vec3 world_of(const Interval& interval, float along, const glm::mat4& clip_from_world) {
    const glm::vec3 p{interval.start_world[0], interval.start_world[1], interval.start_world[2]};
    const glm::vec3 q{interval.end_world[0], interval.end_world[1], interval.end_world[2]};
    const float p_w = (clip_from_world * glm::vec4{p, 1}).w;
    const float q_w = (clip_from_world * glm::vec4{q, 1}).w;
    const float share = along * p_w / ((1 - along) * q_w + along * p_w);
    return p + (q - p) * share;
}

Segment segment_at(compute::Device& device, const LineTables& tables, std::uint32_t segment) {
    const auto after = std::ranges::upper_bound(
        tables.chunks, segment, {}, [](const auto& chunk) { return chunk.range.first; });
    const LineTables::Chunk& chunk = *(after - 1);
    return compute::read_one<Segment>(device, *chunk.segments, segment - chunk.range.first);
}

/// The ray from the near plane on through a window position.
std::optional<Ray> ray_through(const Camera& camera, glm::vec2 position) {
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4{camera.clip_from_world()});
    const glm::dvec2 seen = 2.0 * glm::dvec2{position} / glm::dvec2{camera.size} - 1.0;
    const auto point = [&](double depth) {
        const glm::dvec4 p = world_from_clip * glm::dvec4{seen, depth, 1};
        return glm::dvec3{p} / p.w;
    };
    const glm::dvec3 origin = point(-1), way = point(0) - origin;
    const double length = glm::length(way);
    if (!(length > 0) || !std::isfinite(length)) return {};
    return Ray{origin, way / length};
}

} // namespace

void check_pick(glm::vec2 position, float radius) {
    if (!std::isfinite(position.x) || !std::isfinite(position.y))
        throw UsageError("pick: the position must be two finite numbers of pixels");
    if (!(radius >= 0 && radius <= largest_radius))
        throw UsageError("pick: the radius must be 0 to 1000 pixels");
}

std::optional<Pick> pick(ExactIntervals& found, compute::Device& device, const PlacedLines& lines,
                         std::span<const LineObject> objects, const LineView& view,
                         glm::vec2 position, float radius) {
    check_pick(position, radius);
    const PictureTile part = around(position, radius, view.camera.size);
    if (part.size.x <= 0 || part.size.y <= 0) return {};
    Camera camera = view.camera;
    camera.projection = tile_projection(camera.projection, part, camera.size);
    camera.size = part.size;
    // A line may be short because the part of the picture cuts it, so no line is left out for being
    // short.
    const LineView near{.camera = camera,
                        .bounds = view.bounds,
                        .contact = view.contact,
                        .lines = view.lines,
                        .step = finest_step};
    const std::vector<Interval> intervals = found.find(lines, near, {}, ProgressPart::none());
    const glm::vec2 in_part = position - glm::vec2{part.low};
    // Where lines meet, the one in front is picked.
    constexpr float as_near = 1e-3F;
    const Interval* best = nullptr;
    Nearest place;
    for (const Interval& interval : intervals) {
        const Nearest one = nearest_of(interval, in_part);
        if (!(one.distance <= radius)) continue;
        const bool nearer = best == nullptr || one.distance < place.distance - as_near ||
                            (one.distance < place.distance + as_near && one.depth < place.depth);
        if (!nearer) continue;
        best = &interval;
        place = one;
    }
    if (best != nullptr) {
        const Segment segment = segment_at(device, lines.tables, best->segment);
        const glm::vec2 start{best->start[0], best->start[1]}, end{best->end[0], best->end[1]};
        return Pick{.segment = best->segment,
                    .kind = static_cast<LineKind>(segment.tag & LA_TAG_KIND_MASK),
                    .object = object_of(objects, segment.p),
                    .position = glm::mix(start, end, place.along) + glm::vec2{part.low},
                    .distance = place.distance,
                    .world = world_of(*best, place.along, camera.clip_from_world())};
    }
    const glm::vec2 size{view.camera.size};
    const bool inside =
        position.x >= 0 && position.y >= 0 && position.x <= size.x && position.y <= size.y;
    const std::optional<Ray> ray = inside ? ray_through(view.camera, position) : std::nullopt;
    if (!ray) return {};
    const auto vertices = compute::read_back<glm::vec3>(device, lines.vertices, lines.vertex_count);
    const auto triangles =
        compute::read_back<glm::uvec3>(device, *lines.tables.triangles, lines.triangle_count);
    const std::optional<RayHit> hit = first_hit(*ray, vertices, triangles);
    if (!hit) return {};
    return Pick{.triangle = hit->triangle,
                .object = object_of(objects, triangles[hit->triangle].x),
                .position = position,
                .world = ray->at(hit->distance)};
}

} // namespace lineatlas
