#include "scene_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/objects.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

// There are up to twice as many landmarks.
constexpr std::size_t most_landmarks = 256;

/// The window position of a point in pixels; nothing outside the picture.
std::optional<glm::vec2> window_position(glm::vec3 point, const glm::mat4& clip_from_object,
                                         glm::vec2 size) {
    const glm::vec4 clip = clip_from_object * glm::vec4{point, 1};
    if (!(std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w)) return std::nullopt;
    return (glm::vec2{clip} / clip.w + 1.0F) * 0.5F * size;
}

void include(Bounds& bounds, glm::vec3 point) {
    bounds.min = glm::min(bounds.min, point);
    bounds.max = glm::max(bounds.max, point);
}

/// A matrix that takes everything to a point which no usual camera sees. The point is near enough
/// for floats to hold squares of its distance.
glm::mat4 matrix_away(const Bounds& bounds) {
    constexpr float diagonals = 1e6F;
    const float far = diagonals * std::max(glm::distance(bounds.min, bounds.max), 1e-6F);
    const glm::vec3 point = 0.5F * (bounds.min + bounds.max) + far * glm::vec3{0.36F, 0.48F, 0.8F};
    return {glm::vec4{0}, glm::vec4{0}, glm::vec4{0}, glm::vec4{point, 1}};
}

/// The most that a corner of a box moves on the screen; infinite if one is behind the eye.
float largest_shift(const Bounds& box, const glm::mat4& clip_from, const glm::mat4& clip_to,
                    glm::vec2 size) {
    float largest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec4 point{(corner & 1) != 0 ? box.max.x : box.min.x,
                              (corner & 2) != 0 ? box.max.y : box.min.y,
                              (corner & 4) != 0 ? box.max.z : box.min.z, 1};
        const glm::vec4 a = clip_from * point, b = clip_to * point;
        if (!(a.w > 0 && b.w > 0)) return std::numeric_limits<float>::infinity();
        const glm::vec2 shift = (glm::vec2{b} / b.w - glm::vec2{a} / a.w) * 0.5F * size;
        largest = std::max(largest, glm::length(shift));
    }
    return largest;
}

} // namespace

SceneMotion::SceneMotion(const LineSet& lines)
    : objects_(lines.objects), vertex_count_(static_cast<std::uint32_t>(lines.vertices.size())),
      away_(matrix_away(lines.bounds)), bounds_(lines.bounds) {
    if (objects_.empty()) objects_.push_back({.name = {}, .vertex_count = vertex_count_});
    transforms_.assign(objects_.size(), glm::mat4{1});
    hidden_.assign(objects_.size(), 0);
    shown_ = transforms_;
    for (const LineObject& object : objects_) {
        Bounds& box = boxes_.emplace_back();
        if (objects_.size() == 1) {
            box = lines.bounds;
            continue;
        }
        for (std::uint32_t i = 0; i < object.vertex_count; ++i) {
            include(box, lines.vertices[object.first_vertex + i]);
        }
    }
    std::size_t vertices = 0;
    for (const LineObject& object : objects_) vertices += object.vertex_count;
    between_landmarks_ = std::max<std::size_t>(1, vertices / most_landmarks);
    for (std::uint32_t i = 0; i < objects_.size(); ++i) add_landmarks(i, lines.vertices);
}

void SceneMotion::add_landmarks(std::uint32_t object, std::span<const glm::vec3> vertices) {
    const LineObject& own = objects_[object];
    for (; next_landmark_ < own.vertex_count; next_landmark_ += between_landmarks_) {
        const auto vertex = static_cast<std::uint32_t>(own.first_vertex + next_landmark_);
        landmarks_.push_back({vertex, object, vertices[vertex]});
        if (landmarks_.size() < 2 * most_landmarks) continue;
        std::size_t kept = 0; // the model has grown, so half of the landmarks will do
        for (std::size_t i = 0; i < landmarks_.size(); i += 2) landmarks_[kept++] = landmarks_[i];
        landmarks_.resize(kept);
        between_landmarks_ *= 2;
    }
    next_landmark_ -= own.vertex_count;
}

void SceneMotion::set_object(std::uint32_t number, const LineSet& lines, const Bounds& box) {
    if (number >= objects_.size()) {
        objects_.resize(number + 1);
        transforms_.resize(number + 1);
        hidden_.resize(number + 1);
        shown_.resize(number + 1);
        boxes_.resize(number + 1);
    }
    objects_[number] = lines.objects[number];
    transforms_[number] = glm::mat4{1};
    hidden_[number] = 0;
    boxes_[number] = box;
    std::erase_if(landmarks_, [&](const Landmark& one) { return one.object == number; });
    add_landmarks(number, lines.vertices);
    away_ = matrix_away(lines.bounds);
    ++shape_version_;
    update();
}

void SceneMotion::set_transforms(std::span<const glm::mat4> world_from_object) {
    check_transforms(world_from_object, objects_.size());
    transforms_.assign(world_from_object.begin(), world_from_object.end());
    update();
}

void SceneMotion::set_hidden(std::span<const std::uint32_t> objects) {
    check_objects(objects, objects_.size());
    std::ranges::fill(hidden_, std::uint8_t{0});
    for (const std::uint32_t object : objects) hidden_[object] = 1;
    ++shape_version_;
    update();
}

void SceneMotion::set_positions(std::uint32_t first, std::span<const glm::vec3> positions) {
    if (first > vertex_count_ || positions.size() > vertex_count_ - first) {
        throw UsageError("set_positions(): the positions from " + std::to_string(first) +
                         " to below " + std::to_string(first + positions.size()) +
                         " do not fit the " + std::to_string(vertex_count_) +
                         " vertices of the lines");
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3 p = positions[i];
        if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) {
            throw UsageError("set_positions(): position " + std::to_string(first + i) +
                             " is not finite");
        }
    }
    const std::size_t end = first + positions.size();
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        const std::size_t own_first = objects_[i].first_vertex;
        const std::size_t own_end = own_first + objects_[i].vertex_count;
        const std::size_t low = std::max<std::size_t>(first, own_first);
        const std::size_t high = std::min(end, own_end);
        if (low >= high) continue;
        // The host does not know the other vertices. If positions of an object come in parts, its
        // box only grows.
        if (low == own_first && high == own_end) boxes_[i] = {};
        for (std::size_t v = low; v < high; ++v) include(boxes_[i], positions[v - first]);
    }
    for (Landmark& landmark : landmarks_) {
        if (landmark.vertex >= first && landmark.vertex < end) {
            landmark.position = positions[landmark.vertex - first];
        }
    }
    ++shape_version_;
    update();
}

void SceneMotion::update() {
    bounds_ = {};
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        shown_[i] = hidden_[i] != 0 ? away_ : transforms_[i];
        if (objects_[i].vertex_count == 0) continue;
        const bool as_made = transforms_[i] == glm::mat4{1};
        const Bounds box = as_made ? boxes_[i] : moved(boxes_[i], transforms_[i]);
        include(bounds_, box.min);
        include(bounds_, box.max);
    }
}

float SceneMotion::typical_motion(const Camera& from, std::span<const glm::mat4> transforms_from,
                                  const Camera& to) const {
    const glm::mat4 clip_from = from.clip_from_world(), clip_to = to.clip_from_world();
    if (clip_from == clip_to && std::ranges::equal(transforms_from, shown_)) return 0;
    std::array<float, 2 * most_landmarks> shifts;
    std::size_t count = 0;
    for (const Landmark& landmark : landmarks_) {
        const auto a = window_position(
            landmark.position, clip_from * transforms_from[landmark.object], glm::vec2{from.size});
        const auto b = window_position(landmark.position, clip_to * shown_[landmark.object],
                                       glm::vec2{to.size});
        if (a && b) shifts[count++] = glm::distance(*a, *b);
    }
    if (count == 0) return std::numeric_limits<float>::infinity();
    const auto middle = shifts.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(shifts.begin(), middle, shifts.begin() + static_cast<std::ptrdiff_t>(count));
    return *middle;
}

std::vector<std::uint8_t> SceneMotion::jumped(std::span<const glm::mat4> transforms_from,
                                              const Camera& to, float most_pixels) const {
    std::vector<std::uint8_t> result;
    const glm::mat4 clip = to.clip_from_world();
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        if (transforms_from[i] == shown_[i] || objects_[i].vertex_count == 0) continue;
        const float shift = largest_shift(boxes_[i], clip * transforms_from[i], clip * shown_[i],
                                          glm::vec2{to.size});
        if (shift <= most_pixels) continue;
        result.resize(objects_.size());
        result[i] = 1;
    }
    return result;
}

} // namespace lineatlas
