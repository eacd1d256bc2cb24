#include "rim_ends.hpp"

#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/geometric.hpp>

#include "core/plane_vectors.hpp"
#include "paths.hpp"
#include "pieces.hpp"
#include "segment_grid.hpp"

namespace lineatlas {
namespace {

constexpr double at_chord = 0.03;  ///< of what ends there, pixels
constexpr double farthest = 1;     ///< between a chord and its curve, pixels
constexpr double least_sine = 0.2; ///< between lines that cross
constexpr double shortest = 1e-3;  ///< step that has a direction, pixels

/// The way from the end of a line on to where it meets the line from `a` to `b`, in lengths of its
/// last step; below 0 back along that step.
std::optional<double> way_to(glm::dvec2 a, glm::dvec2 b, glm::dvec2 before, glm::dvec2 end) {
    const glm::dvec2 step = end - before, way = b - a;
    const double length = glm::length(step), area = cross(step, way);
    if (!(std::abs(area) > least_sine * length * glm::length(way))) return std::nullopt;
    const double share = cross(a - end, way) / area, on_rim = cross(a - end, step) / area;
    if (on_rim < 0 || on_rim > 1 || share < -1 || std::abs(share) * length > farthest)
        return std::nullopt;
    return share;
}

} // namespace

RimEnds::RimEnds(const std::vector<VectorPath>& paths, glm::dvec2 size,
                 const std::function<bool(const VectorPath&, const VectorPiece&)>& is_bent)
    : size_(size) {
    struct Chord {
        glm::dvec2 from, to;
        std::uint32_t path;
    };
    std::vector<Chord> chords;
    SegmentGrid grid{size};
    for (std::uint32_t i = 0; i < paths.size(); ++i) {
        if (!paths[i].visible) continue;
        for (const VectorPiece& piece : paths[i].pieces) {
            if (!is_bent(paths[i], piece)) continue;
            const Chord chord{paths[i].points[piece.point].at, paths[i].points[piece.point + 1].at,
                              i};
            grid.insert(chord.from, chord.to, static_cast<std::uint32_t>(chords.size()));
            chords.push_back(chord);
        }
    }
    if (chords.empty()) return;
    for (std::uint32_t i = 0; i < paths.size(); ++i) {
        if (paths[i].closed) continue;
        for (const bool at_end : {false, true}) {
            const glm::dvec2 end = (at_end ? paths[i].points.back() : paths[i].points.front()).at;
            for (const std::uint32_t k : grid.near(end, end, at_chord))
                if (chords[k].path != i &&
                    distance_to(end, chords[k].from, chords[k].to) < at_chord) {
                    touches_.push_back({i, at_end, chords[k].path});
                    break;
                }
        }
    }
}

void RimEnds::move(std::vector<VectorPath>& paths) const {
    if (touches_.empty()) return;
    std::vector<bool> is_rim(paths.size(), false);
    for (const Touch& touch : touches_) is_rim[touch.rim] = true;
    struct Chord {
        std::uint32_t path;
        std::size_t point;
    };
    std::vector<Chord> chords;
    SegmentGrid grid{size_};
    for (std::uint32_t i = 0; i < paths.size(); ++i) {
        if (!is_rim[i]) continue;
        const std::vector<VectorPoint>& points = paths[i].points;
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            grid.insert(points[k].at, points[k + 1].at, static_cast<std::uint32_t>(chords.size()));
            chords.push_back({i, k});
        }
    }
    for (const Touch& touch : touches_) {
        std::vector<VectorPoint>& points = paths[touch.path].points;
        VectorPoint& end = touch.at_end ? points.back() : points.front();
        const VectorPoint& before = touch.at_end ? points[points.size() - 2] : points[1];
        if (!(glm::distance(before.at, end.at) > shortest)) continue;
        std::optional<double> nearest;
        for (const std::uint32_t k : grid.near(end.at, end.at, farthest)) {
            if (chords[k].path != touch.rim) continue;
            const std::vector<VectorPoint>& rim = paths[touch.rim].points;
            const std::size_t first = chords[k].point;
            const auto way = way_to(rim[first].at, rim[first + 1].at, before.at, end.at);
            if (way && (!nearest || std::abs(*way) < std::abs(*nearest))) nearest = way;
        }
        if (nearest) end = between(before, end, 1 + *nearest);
    }
}

} // namespace lineatlas
