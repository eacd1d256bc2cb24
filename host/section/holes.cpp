#include "holes.hpp"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "core/plane_vectors.hpp"

namespace lineatlas {
namespace {

bool in_triangle(glm::dvec2 at, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    const double u = cross(b - a, at - a), v = cross(c - b, at - b), w = cross(a - c, at - c);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

/// Whether the way from a corner of a ring to `to` starts on the ring's inside.
bool starts_inside(const Ring& ring, std::size_t corner, glm::dvec2 to) {
    const glm::dvec2 at = ring[corner].at;
    const glm::dvec2 before = ring[(corner + ring.size() - 1) % ring.size()].at - at;
    const glm::dvec2 after = ring[(corner + 1) % ring.size()].at - at;
    const glm::dvec2 way = to - at;
    const bool convex = cross(after, before) > 0;
    const bool left_of_after = cross(after, way) >= 0, right_of_before = cross(way, before) >= 0;
    return convex ? left_of_after && right_of_before : left_of_after || right_of_before;
}

std::size_t rightmost(const Ring& ring) {
    return static_cast<std::size_t>(
        std::ranges::max_element(ring, {}, [](const RingPoint& point) { return point.at.x; }) -
        ring.begin());
}

/// A corner of the ring that can be seen from `from`, which lies within the ring (Eberly,
/// "Triangulation by Ear Clipping"). It is a corner of the edge to the right of `from`, unless
/// other corners stand in between.
std::size_t visible_corner(const Ring& ring, glm::dvec2 from) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t found = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a = ring[i].at, b = ring[(i + 1) % ring.size()].at;
        if ((a.y > from.y) == (b.y > from.y)) continue;
        const double x = a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (x < from.x || x >= nearest) continue;
        nearest = x;
        found = a.x > b.x ? i : (i + 1) % ring.size();
    }
    const glm::dvec2 hit{nearest, from.y};
    const glm::dvec2 corner = ring[found].at;
    double best = -1;
    std::size_t chosen = found;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 at = ring[i].at;
        if (at.x < from.x || !in_triangle(at, from, hit, corner)) continue;
        // Earlier bridges have left several corners at one place. One of them looks this way.
        if (!starts_inside(ring, i, from)) continue;
        const glm::dvec2 way = at - from;
        const double length = glm::length(way);
        const double level = length > 0 ? way.x / length : 2;
        if (level > best || (level == best && length < glm::distance(ring[chosen].at, from))) {
            best = level;
            chosen = i;
        }
    }
    return chosen;
}

} // namespace

Ring bridged(Ring outline, std::vector<Ring> holes) {
    // Holes are joined from the right, so each bridge meets the outline or a hole that is already
    // joined.
    std::ranges::sort(holes, std::ranges::greater{},
                      [](const Ring& hole) { return hole[rightmost(hole)].at.x; });
    for (Ring& hole : holes) {
        std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(rightmost(hole)),
                    hole.end());
        const std::size_t corner = visible_corner(outline, hole.front().at);
        Ring bridge = std::move(hole);
        bridge.push_back(bridge.front());
        bridge.push_back(outline[corner]);
        outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(corner) + 1, bridge.begin(),
                       bridge.end());
    }
    return outline;
}

} // namespace lineatlas
