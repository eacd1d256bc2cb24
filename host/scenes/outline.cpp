// Outlines and their triangulation by ear clipping, with holes bridged to the outline first.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "builder.hpp"

namespace lineatlas::scenes {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

float cross(glm::vec2 a, glm::vec2 b) {
    return a.x * b.y - a.y * b.x;
}

float signed_area(const Outline& outline) {
    float sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        sum += cross(outline[i], outline[(i + 1) % outline.size()]);
    return 0.5F * sum;
}

bool segments_cross(glm::vec2 a, glm::vec2 b, glm::vec2 c, glm::vec2 d) {
    if (a == c || a == d || b == c || b == d) return false;
    const bool sides = cross(b - a, c - a) * cross(b - a, d - a) <= 0;
    return sides && cross(d - c, a - c) * cross(d - c, b - c) <= 0;
}

bool inside_triangle(glm::vec2 p, glm::vec2 a, glm::vec2 b, glm::vec2 c) {
    if (p == a || p == b || p == c) return false;
    return cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0;
}

using Loop = std::vector<std::uint32_t>;

bool crosses_loop(const std::vector<glm::vec2>& at, const Loop& loop, glm::vec2 a, glm::vec2 b) {
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (segments_cross(a, b, at[loop[i]], at[loop[(i + 1) % loop.size()]])) return true;
    return false;
}

/// Joins a hole to the polygon along the shortest bridge that crosses no edge.
void bridge(const std::vector<glm::vec2>& at, Loop& polygon, const std::vector<Loop>& holes,
            std::size_t hole_index) {
    const Loop& hole = holes[hole_index];
    float best = INFINITY;
    std::size_t from = 0;
    std::size_t to = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        for (std::size_t j = 0; j < hole.size(); ++j) {
            const glm::vec2 a = at[polygon[i]];
            const glm::vec2 b = at[hole[j]];
            const float length = glm::distance(a, b);
            if (length >= best || crosses_loop(at, polygon, a, b)) continue;
            bool free = true;
            for (std::size_t k = hole_index; k < holes.size() && free; ++k)
                free = !crosses_loop(at, holes[k], a, b);
            if (!free) continue;
            best = length;
            from = i;
            to = j;
        }
    }
    Loop joined(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(from) + 1);
    for (std::size_t j = 0; j <= hole.size(); ++j) joined.push_back(hole[(to + j) % hole.size()]);
    joined.insert(joined.end(), polygon.begin() + static_cast<std::ptrdiff_t>(from), polygon.end());
    polygon = std::move(joined);
}

/// Lawson's flips: an inner edge is swapped where the other diagonal of its quadrilateral is the
/// Delaunay one. Ears leave slivers, and slivers draw stray lines once a face is not quite flat.
void flip_to_delaunay(const std::vector<glm::vec2>& at, std::vector<glm::uvec3>& triangles) {
    auto opposite_cosine = [&](glm::vec2 corner, glm::vec2 a, glm::vec2 b) {
        return glm::dot(glm::normalize(a - corner), glm::normalize(b - corner));
    };
    bool flipped = true;
    for (int round = 0; flipped && round < 50; ++round) {
        flipped = false;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            for (std::size_t j = i + 1; j < triangles.size(); ++j) {
                for (int e = 0; e < 9; ++e) {
                    glm::uvec3& s = triangles[i];
                    glm::uvec3& t = triangles[j];
                    const std::uint32_t a = s[e / 3];
                    const std::uint32_t b = s[(e / 3 + 1) % 3];
                    const std::uint32_t c = s[(e / 3 + 2) % 3];
                    const std::uint32_t d = t[(e % 3 + 2) % 3];
                    if (t[e % 3] != b || t[(e % 3 + 1) % 3] != a) continue;
                    // Opposite angles of more than 180 degrees in sum: the cosines' sum is
                    // negative.
                    if (opposite_cosine(at[c], at[a], at[b]) +
                            opposite_cosine(at[d], at[a], at[b]) >
                        -1e-4F)
                        continue;
                    const bool convex = cross(at[d] - at[a], at[c] - at[d]) > 0 &&
                                        cross(at[b] - at[d], at[c] - at[b]) > 0;
                    if (!convex) continue;
                    s = {a, d, c};
                    t = {d, b, c};
                    flipped = true;
                    break;
                }
            }
        }
    }
}

} // namespace

Outline rectangle(glm::vec2 lo, glm::vec2 hi) {
    return {lo, {hi.x, lo.y}, hi, {lo.x, hi.y}};
}

Outline circle(glm::vec2 centre, float radius, int segments, float phase) {
    Outline result;
    for (int i = 0; i < segments; ++i) {
        const float angle = phase + 2 * pi * static_cast<float>(i) / static_cast<float>(segments);
        result.push_back(centre + radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return result;
}

Outline rounded_rectangle(glm::vec2 lo, glm::vec2 hi, float radius, int segments) {
    Outline result;
    const glm::vec2 centres[] = {{hi.x - radius, hi.y - radius},
                                 {lo.x + radius, hi.y - radius},
                                 {lo.x + radius, lo.y + radius},
                                 {hi.x - radius, lo.y + radius}};
    for (int corner = 0; corner < 4; ++corner) {
        for (int i = 0; i <= segments; ++i) {
            const float turns = static_cast<float>(i) / static_cast<float>(segments);
            const float angle = 0.5F * pi * (static_cast<float>(corner) + turns);
            result.push_back(centres[corner] +
                             radius * glm::vec2(std::cos(angle), std::sin(angle)));
        }
    }
    return result;
}

std::vector<glm::uvec3> triangulate(const Outline& outline, std::span<const Outline> holes) {
    std::vector<glm::vec2> at(outline);
    Loop polygon(outline.size());
    for (std::uint32_t i = 0; i < polygon.size(); ++i) polygon[i] = i;
    std::vector<Loop> inner;
    for (const Outline& hole : holes) {
        Loop loop(hole.size());
        for (std::uint32_t i = 0; i < loop.size(); ++i)
            loop[i] = static_cast<std::uint32_t>(at.size()) + i;
        at.insert(at.end(), hole.begin(), hole.end());
        if (signed_area(hole) > 0) std::reverse(loop.begin(), loop.end());
        inner.push_back(std::move(loop));
    }
    for (std::size_t i = 0; i < inner.size(); ++i) bridge(at, polygon, inner, i);

    std::vector<glm::uvec3> result;
    while (polygon.size() > 3) {
        // The ear with the shortest cut keeps slivers away.
        const std::size_t n = polygon.size();
        float best = INFINITY;
        std::size_t ear = n;
        for (std::size_t i = 0; i < n; ++i) {
            const glm::vec2 a = at[polygon[(i + n - 1) % n]];
            const glm::vec2 b = at[polygon[i]];
            const glm::vec2 c = at[polygon[(i + 1) % n]];
            const float length = glm::distance(a, c);
            if (length >= best || cross(b - a, c - b) <= 1e-5F * glm::dot(c - a, c - a)) continue;
            const bool empty = std::none_of(polygon.begin(), polygon.end(), [&](std::uint32_t k) {
                return inside_triangle(at[k], a, b, c);
            });
            if (!empty) continue;
            best = length;
            ear = i;
        }
        if (ear == n) break; // only points on one line are left
        result.emplace_back(polygon[(ear + n - 1) % n], polygon[ear], polygon[(ear + 1) % n]);
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    if (polygon.size() == 3) result.emplace_back(polygon[0], polygon[1], polygon[2]);
    flip_to_delaunay(at, result);
    return result;
}

} // namespace lineatlas::scenes
