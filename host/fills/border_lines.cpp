#include "border_lines.hpp"

#include <compare>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "core/pair_key.hpp"

namespace lineatlas {
namespace {

/// A triangle at one of its edges.
struct EdgeSide {
    std::uint64_t edge;
    std::uint32_t triangle;
    bool ascends; ///< its winding goes from the smaller vertex to the larger one

    auto operator<=>(const EdgeSide&) const = default;
};

std::vector<EdgeSide> edge_sides(const std::vector<glm::uvec3>& triangles) {
    std::vector<EdgeSide> sides(3 * triangles.size());
    for_each_index(triangles.size(), [&](std::size_t i) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t p = triangles[i][k], q = triangles[i][(k + 1) % 3];
            sides[3 * i + static_cast<std::size_t>(k)] = {pair_key(p, q),
                                                          static_cast<std::uint32_t>(i), p < q};
        }
    });
    sort_in_pieces(sides);
    return sides;
}

/// Per triangle 1 if its winding looks at the eye, -1 if it looks away, 0 if it is seen edge on.
std::vector<signed char> facings(const LineSet& lines, const Camera& camera) {
    const glm::dvec4 eye{camera.eye()};
    std::vector<signed char> result(lines.triangles.size());
    for_each_index(result.size(), [&](std::size_t i) {
        const glm::uvec3 t = lines.triangles[i];
        const glm::dvec3 a{lines.vertices[t.x]}, b{lines.vertices[t.y]}, c{lines.vertices[t.z]};
        const double toward = glm::dot(glm::cross(b - a, c - a), glm::dvec3{eye} - a * eye.w);
        result[i] = static_cast<signed char>((toward > 0) - (toward < 0));
    });
    return result;
}

class Borders {
  public:
    Borders(std::span<const std::uint32_t> looks, const std::vector<signed char>& facing)
        : looks_(looks), facing_(facing) {}

    /// Whether an edge with these triangles is one.
    bool has(std::span<const EdgeSide> sides) const {
        if (sides.size() != 2) return true;
        const auto [edge_a, a, a_ascends] = sides[0];
        const auto [edge_b, b, b_ascends] = sides[1];
        const int turned = a_ascends == b_ascends ? -1 : 1;
        const bool bends_away = facing_[a] != turned * facing_[b] || facing_[a] == 0;
        return bends_away || looks_[a] != looks_[b];
    }

  private:
    std::span<const std::uint32_t> looks_;
    const std::vector<signed char>& facing_;
};

Segment segment_of(std::span<const EdgeSide> sides) {
    const auto low = static_cast<std::uint32_t>(sides[0].edge >> 32U);
    const auto high = static_cast<std::uint32_t>(sides[0].edge);
    Segment segment{.p = low,
                    .q = high,
                    .face_a = sides[0].triangle,
                    .face_b = LA_NO_FACE,
                    .from_start = 0,
                    .to_end = 0,
                    .path = 0,
                    .tag = LA_KIND_CREASE};
    if (!sides[0].ascends) std::swap(segment.p, segment.q);
    if (sides.size() < 2) return segment;
    const bool flipped = sides[0].ascends == sides[1].ascends;
    segment.face_b = sides[1].triangle | (flipped ? LA_FACE_FLIPPED : 0);
    return segment;
}

void add(LineSet& borders, Segment segment) {
    segment.path = borders.path_count++;
    segment.from_start = segment.to_end = 0;
    borders.segments.push_back(segment);
    ++borders.kind_counts[segment.tag & LA_TAG_KIND_MASK];
}

} // namespace

LineSet border_lines(const LineSet& lines, std::span<const std::uint32_t> looks,
                     const Camera& camera) {
    LineSet borders;
    borders.vertices = lines.vertices;
    borders.triangles = lines.triangles;
    borders.bounds = lines.bounds;
    borders.precision = lines.precision;
    const std::vector<signed char> facing = facings(lines, camera);
    const Borders is_border{looks, facing};
    const std::vector<EdgeSide> sides = edge_sides(lines.triangles);
    for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
        while (end < sides.size() && sides[end].edge == sides[first].edge) ++end;
        const std::span of_edge = std::span{sides}.subspan(first, end - first);
        if (is_border.has(of_edge)) add(borders, segment_of(of_edge));
        if (first % usual_piece < 2) ask_between_pieces(); // edges have about two sides
    }
    for (Segment segment : lines.segments) {
        if ((segment.tag & LA_TAG_KIND_MASK) != LA_KIND_INTERSECTION) continue;
        segment.tag = LA_KIND_INTERSECTION;
        add(borders, segment);
    }
    return borders;
}

} // namespace lineatlas
