#include "face_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "base/parallel.hpp"

namespace lineatlas {
namespace {

struct HalfEdgesOfFaces {
    std::vector<std::uint32_t> first; ///< per face, and one behind the last, into `list`
    std::vector<std::uint32_t> list;

    std::span<const std::uint32_t> of(std::uint32_t face) const {
        return std::span{list}.subspan(first[face], first[face + 1] - first[face]);
    }
};

HalfEdgesOfFaces half_edges_of_faces(const PlanarMap& map) {
    HalfEdgesOfFaces edges{std::vector<std::uint32_t>(map.face_count() + 1, 0), {}};
    const auto for_each = [&](const auto& each) {
        for (std::uint32_t h = 0; h < map.half_edge_count(); ++h)
            if (map.face(h) != PlanarMap::outside) each(map.face(h), h);
    };
    for_each([&](std::uint32_t face, std::uint32_t) { ++edges.first[face + 1]; });
    std::partial_sum(edges.first.begin(), edges.first.end(), edges.first.begin());
    edges.list.resize(edges.first.back());
    std::vector<std::uint32_t> at = edges.first;
    for_each([&](std::uint32_t face, std::uint32_t h) { edges.list[at[face]++] = h; });
    return edges;
}

/// The heights at which points of a face are looked for, evenly spread. No corner lies at one of
/// them: they are between two rows of the grid.
std::vector<double> heights_between(double low, double high, double apart) {
    constexpr double least = 5;
    const double count = std::max(least, std::ceil((high - low) / apart));
    std::vector<double> heights;
    for (double i = 0.5; i < count; ++i) {
        const double at = std::floor(low + (high - low) * i / count) + 0.5;
        if (heights.empty() || heights.back() < at) heights.push_back(at);
    }
    return heights;
}

/// Per height the places where half-edges pass it, from left to right.
std::vector<std::vector<double>> crossings_at(const PlanarMap& map,
                                              std::span<const std::uint32_t> half_edges,
                                              const std::vector<double>& heights) {
    std::vector<std::vector<double>> crossings(heights.size());
    for (const std::uint32_t h : half_edges) {
        const glm::dvec2 a{map.start(h)}, b{map.end(h)};
        const auto first = std::ranges::lower_bound(heights, std::min(a.y, b.y));
        const auto end = std::ranges::lower_bound(heights, std::max(a.y, b.y));
        for (auto height = first; height < end; ++height)
            crossings[static_cast<std::size_t>(height - heights.begin())].push_back(
                a.x + (b.x - a.x) * ((*height - a.y) / (b.y - a.y)));
    }
    for (std::vector<double>& row : crossings) std::ranges::sort(row);
    return crossings;
}

/// Adds points of the part of a face between two of its borders: beside both, where it would be
/// seen if one were missing, and in the middle.
void add_points_between(std::uint32_t face, double from, double to, double height, double pixel,
                        std::vector<FacePoint>& points) {
    constexpr double beside = 0.25; // pixels
    const double reach = std::min(beside * pixel, 0.25 * (to - from));
    points.push_back({face, {from + reach, height}, reach});
    points.push_back({face, {0.5 * (from + to), height}, to - from - 2 * reach});
    points.push_back({face, {to - reach, height}, reach});
}

} // namespace

std::vector<FacePoint> face_points(const PlanarMap& map, double pixel,
                                   const std::vector<bool>& closely) {
    constexpr double apart = 3; // pixels
    constexpr double far = std::numeric_limits<double>::infinity();
    const HalfEdgesOfFaces edges = half_edges_of_faces(map);
    std::vector<FacePoint> points;
    for (std::uint32_t face = 0; face < map.face_count(); ++face) {
        ask_between_pieces();
        const std::span<const std::uint32_t> own = edges.of(face);
        const auto height_of = [&](std::uint32_t h) { return static_cast<double>(map.start(h).y); };
        const auto [low, high] = std::ranges::minmax(own, {}, height_of);
        const std::vector<double> heights =
            heights_between(height_of(low), height_of(high), closely[face] ? apart * pixel : far);
        const std::vector<std::vector<double>> crossings = crossings_at(map, own, heights);
        for (std::size_t i = 0; i < heights.size(); ++i)
            for (std::size_t k = 0; k + 1 < crossings[i].size(); k += 2)
                add_points_between(face, crossings[i][k], crossings[i][k + 1], heights[i], pixel,
                                   points);
    }
    return points;
}

} // namespace lineatlas
