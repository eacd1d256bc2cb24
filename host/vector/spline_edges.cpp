#include "spline_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

/// Curves are divided so that neighbouring chords turn by less than this. If chords turn by more,
/// the curve has a corner.
constexpr double most_turn = 17 * std::numbers::pi / 180;
constexpr double least_turn = 1e-4;                       ///< chords that turn by less are straight
constexpr double most_turn_beside = 3;                    ///< times the turns before and behind
constexpr double least_kink = 5 * std::numbers::pi / 180; ///< smaller turns are not asked that
constexpr double most_uneven = 4;                         ///< ratio of the lengths of two chords
constexpr std::ptrdiff_t reach = 2; ///< points on either side that tell a direction

double angle_between(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// The derivative, at one of a few points, of the polynomial through all of them. Its parameter is
/// the way along the chords.
glm::dvec3 derivative(std::span<const glm::dvec3> points, std::size_t at) {
    constexpr std::size_t most = 2 * reach + 1;
    std::array<double, most> way{};
    for (std::size_t i = 1; i < points.size(); ++i)
        way[i] = way[i - 1] + glm::distance(points[i - 1], points[i]);
    glm::dvec3 sum{0};
    for (std::size_t j = 0; j < points.size(); ++j) {
        if (j == at) continue;
        // By Lagrange's polynomials. That of j is 1 at j and 0 at `at`; that of `at` has the rest.
        double slope = 1 / (way[j] - way[at]);
        for (std::size_t k = 0; k < points.size(); ++k)
            if (k != j && k != at) slope *= (way[at] - way[k]) / (way[j] - way[k]);
        sum += slope * (points[j] - points[at]);
    }
    return sum;
}

/// The direction of the curve at one of the points along it, as long as 1.
glm::dvec3 direction(std::span<const glm::dvec3> points, std::size_t at) {
    const auto count = static_cast<std::ptrdiff_t>(points.size());
    const auto own = static_cast<std::ptrdiff_t>(at);
    const std::ptrdiff_t width = std::min(2 * reach + 1, count);
    const std::ptrdiff_t begin = std::clamp(own - reach, std::ptrdiff_t{0}, count - width);
    std::span<const glm::dvec3> about =
        points.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(width));
    double shortest = glm::distance(about[0], about[1]), longest = shortest;
    for (std::size_t i = 2; i < about.size(); ++i) {
        const double chord = glm::distance(about[i - 1], about[i]);
        shortest = std::min(shortest, chord);
        longest = std::max(longest, chord);
    }
    auto within = static_cast<std::size_t>(own - begin);
    if (longest > most_uneven * shortest && about.size() > 3) {
        const std::size_t first = std::clamp<std::size_t>(within, 1, about.size() - 2) - 1;
        about = about.subspan(first, 3);
        within -= first;
    }
    return glm::normalize(derivative(about, within));
}

} // namespace

glm::dvec3 SplineEdges::Span::at(double share) const {
    const double s = share, r = 1 - s;
    return r * r * (1 + 2 * s) * from + s * s * (1 + 2 * r) * to + r * r * s * out - s * s * r * in;
}

double SplineEdges::Span::share_of(glm::dvec3 point) const {
    const glm::dvec3 chord = to - from;
    return glm::dot(point - from, chord) / glm::dot(chord, chord);
}

const SplineEdges::Span* SplineEdges::span(std::uint32_t piece) const {
    const auto found = spans_.find(piece);
    return found == spans_.end() ? nullptr : &found->second;
}

SplineEdges::SplineEdges(const Mesh& mesh) {
    const std::vector<KnownEdge>& edges = mesh.known_edges;
    const auto has_curve = [&](const KnownEdge& edge) {
        return edge.edge < mesh.edge_curves.size() && mesh.edge_curves[edge.edge];
    };
    const auto goes_on = [&](const KnownEdge& a, const KnownEdge& b) {
        return a.edge == b.edge && mesh.positions[a.to] == mesh.positions[b.from];
    };
    for (std::uint32_t first = 0; first < edges.size();) {
        std::uint32_t last = first + 1;
        while (last < edges.size() && goes_on(edges[last - 1], edges[last])) ++last;
        if (last - first > 1 && !has_curve(edges[first])) add_run(mesh, first, last - first);
        first = last;
    }
}

void SplineEdges::add_run(const Mesh& mesh, std::uint32_t first, std::uint32_t count) {
    std::vector<glm::dvec3> points{glm::dvec3{mesh.positions[mesh.known_edges[first].from]}};
    for (std::uint32_t i = first; i < first + count; ++i)
        points.emplace_back(mesh.positions[mesh.known_edges[i].to]);
    constexpr double unknown = std::numbers::pi; // beside the ends
    std::vector<double> turns(points.size(), unknown);
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        turns[i] = angle_between(points[i] - points[i - 1], points[i + 1] - points[i]);
    const auto is_corner = [&](std::size_t i) {
        const double beside = std::max(turns[i - 1], turns[i + 1]);
        return turns[i] > most_turn ||
               (turns[i] > least_kink && turns[i] > most_turn_beside * beside);
    };
    std::size_t begin = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (i + 1 < points.size() && !is_corner(i)) continue;
        if (i - begin > 1)
            add_smooth(std::span{points}.subspan(begin, i - begin + 1),
                       first + static_cast<std::uint32_t>(begin));
        begin = i;
    }
}

void SplineEdges::add_smooth(std::span<const glm::dvec3> points, std::uint32_t first) {
    glm::dvec3 out = direction(points, 0);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec3 in = direction(points, i), chord = points[i] - points[i - 1];
        const double turn = angle_between(out, in);
        const double most = 2 * most_turn;
        if (turn > least_turn && angle_between(out, chord) < most &&
            angle_between(in, chord) < most) {
            // As long as the derivatives of an arc of a circle.
            const double length = glm::length(chord) / std::pow(std::cos(turn / 4), 2);
            spans_.emplace(first + static_cast<std::uint32_t>(i - 1), Span{.from = points[i - 1],
                                                                           .to = points[i],
                                                                           .out = length * out,
                                                                           .in = length * in,
                                                                           .turn = turn});
        }
        out = in;
    }
}

} // namespace lineatlas
