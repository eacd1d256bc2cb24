#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace lineatlas {

namespace {

using Corner = std::uint32_t; // a place in the polygon, not a vertex of the mesh

double cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon seen along its Newell normal, counter-clockwise. Dropping an axis instead of
/// turning the plane keeps equal coordinates equal, so exact touches stay exact.
std::vector<glm::dvec2> project(std::span<const glm::vec3> positions,
                                std::span<const std::uint32_t> polygon) {
    const glm::dvec3 origin(positions[polygon[0]]);
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < polygon.size(); ++i)
        normal += glm::cross(glm::dvec3(positions[polygon[i]]) - origin,
                             glm::dvec3(positions[polygon[(i + 1) % polygon.size()]]) - origin);

    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    int u = (axis + 1) % 3;
    int v = (axis + 2) % 3;
    if (normal[axis] < 0.0) std::swap(u, v);

    std::vector<glm::dvec2> flat;
    flat.reserve(polygon.size());
    for (const std::uint32_t index : polygon) {
        const glm::dvec3 point(positions[index]);
        flat.emplace_back(point[u], point[v]);
    }
    return flat;
}

/// Ear clipping over a ring of corners. Only corners that do not turn left can lie inside an ear
/// (Meisters 1975), so only those are kept for the containment test.
class EarClipper {
  public:
    explicit EarClipper(std::vector<glm::dvec2> flat)
        : flat_(std::move(flat)), next_(flat_.size()), previous_(flat_.size()) {
        const auto count = static_cast<Corner>(flat_.size());
        for (Corner i = 0; i < count; ++i) {
            next_[i] = (i + 1) % count;
            previous_[i] = (i + count - 1) % count;
        }
        for (Corner i = 0; i < count; ++i)
            if (!turns_left(i)) reflex_.push_back(i);
    }

    template <typename Emit>
    void run(Emit emit) {
        Corner corner = 0;
        std::size_t left = flat_.size();
        std::size_t since_last_ear = 0;
        while (left > 3) {
            const bool stuck = since_last_ear == left;
            if (stuck) corner = least_harm(corner, left);
            if (!stuck && !is_ear(corner)) {
                corner = next_[corner];
                ++since_last_ear;
                continue;
            }
            const Corner before = previous_[corner];
            const Corner after = next_[corner];
            emit(before, corner, after);
            next_[before] = after;
            previous_[after] = before;
            --left;
            since_last_ear = 0;
            refresh_reflex(corner, before, after);
            // Stepping over the new neighbour keeps a round polygon from becoming a fan of slivers.
            corner = next_[after];
        }
        emit(previous_[corner], corner, next_[corner]);
    }

  private:
    double turn(Corner corner) const {
        return cross(flat_[previous_[corner]], flat_[corner], flat_[next_[corner]]);
    }
    bool turns_left(Corner corner) const { return turn(corner) > 0.0; }

    bool is_ear(Corner corner) const {
        if (!turns_left(corner)) return false;
        const glm::dvec2 a = flat_[previous_[corner]];
        const glm::dvec2 b = flat_[corner];
        const glm::dvec2 c = flat_[next_[corner]];
        const glm::dvec2 low(std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}));
        const glm::dvec2 high(std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}));
        return std::none_of(reflex_.begin(), reflex_.end(), [&](Corner other) {
            const glm::dvec2 p = flat_[other];
            if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) return false;
            // The ends of a bridge to a hole share places with the ear's own corners.
            if (p == a || p == b || p == c) return false;
            return cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0;
        });
    }

    /// The corner to remove if no ear is left, which happens in polygons that cross or touch
    /// themselves, or by rounding. A corner without area comes first, then the one that turns left
    /// most.
    Corner least_harm(Corner start, std::size_t left) const {
        Corner best = start;
        double best_turn = -INFINITY;
        Corner corner = start;
        for (std::size_t i = 0; i < left; ++i, corner = next_[corner]) {
            const double area = turn(corner);
            if (area == 0.0) return corner;
            if (area > best_turn) {
                best = corner;
                best_turn = area;
            }
        }
        return best;
    }

    void refresh_reflex(Corner clipped, Corner before, Corner after) {
        std::erase_if(reflex_, [&](Corner corner) {
            return corner == clipped ||
                   ((corner == before || corner == after) && turns_left(corner));
        });
    }

    std::vector<glm::dvec2> flat_;
    std::vector<Corner> next_;
    std::vector<Corner> previous_;
    std::vector<Corner> reflex_;
};

} // namespace

void triangulate(std::span<const glm::vec3> positions, std::span<const std::uint32_t> polygon,
                 std::vector<glm::uvec3>& triangles) {
    const auto emit = [&](Corner a, Corner b, Corner c) {
        const glm::uvec3 triangle(polygon[a], polygon[b], polygon[c]);
        if (triangle.x != triangle.y && triangle.y != triangle.z && triangle.z != triangle.x)
            triangles.push_back(triangle);
    };
    if (polygon.size() == 3) {
        emit(0, 1, 2);
        return;
    }
    std::vector<glm::dvec2> flat = project(positions, polygon);
    if (polygon.size() == 4) {
        // Either diagonal splits a convex quad. The shorter one gives better triangles, and in a
        // bent quad modellers expect it.
        const bool first =
            cross(flat[0], flat[1], flat[2]) > 0.0 && cross(flat[0], flat[2], flat[3]) > 0.0;
        const bool second =
            cross(flat[1], flat[2], flat[3]) > 0.0 && cross(flat[1], flat[3], flat[0]) > 0.0;
        if (first || second) {
            const auto length = [&](int a, int b) {
                return glm::distance(positions[polygon[a]], positions[polygon[b]]);
            };
            if (first && (!second || length(0, 2) <= length(1, 3))) {
                emit(0, 1, 2);
                emit(0, 2, 3);
            } else {
                emit(1, 2, 3);
                emit(1, 3, 0);
            }
            return;
        }
    }
    EarClipper(std::move(flat)).run(emit);
}

} // namespace lineatlas
