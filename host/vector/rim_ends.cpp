#include "rim_ends.hpp"

#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/geometric.hpp>

#include "paths.hpp"
#include "pieces.hpp"
#include "segment_grid.hpp"

namespace lineatlas {
namespace {

constexpr double at_chord = 0.03;  ///< of what ends there, pixels
constexpr double farthest = 1;     ///< between a chord and its curve, pixels
constexpr double least_sine = 0.2; ///< between lines that cross
constexpr double shortest = 1e-3;  ///< step that has a direction, pixels

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// The way from the end of a line on to where it meets a path, in lengths of its last step; below 0
/// back along that step. The nearest one.
std::optional<double> way_to(const VectorPath& rim, glm::dvec2 before, glm::dvec2 end) {
    const glm::dvec2 step = end - before;
    const double length = glm::length(step);
    if (!(length > shortest)) return std::nullopt;
    std::optional<double> nearest;
    for (std::size_t i = 0; i + 1 < rim.points.size(); ++i) {
        const glm::dvec2 a = rim.points[i].at, way = rim.points[i + 1].at - a;
        const double area = cross(step, way);
        if (!(std::abs(area) > least_sine * length * glm::length(way))) continue;
        const double share = cross(a - end, way) / area, on_rim = cross(a - end, step) / area;
        if (on_rim < 0 || on_rim > 1 || share < -1 || std::abs(share) * length > farthest) continue;
        if (!nearest || std::abs(share) < std::abs(*nearest)) nearest = share;
    }
    return nearest;
}

} // namespace

RimEnds::RimEnds(const std::vector<VectorPath>& paths, glm::dvec2 size,
                 const std::function<bool(const VectorPath&, const VectorPiece&)>& is_bent) {
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
    for (const Touch& touch : touches_) {
        std::vector<VectorPoint>& points = paths[touch.path].points;
        VectorPoint& end = touch.at_end ? points.back() : points.front();
        const VectorPoint& before = touch.at_end ? points[points.size() - 2] : points[1];
        if (const auto way = way_to(paths[touch.rim], before.at, end.at))
            end = between(before, end, 1 + *way);
    }
}

} // namespace lineatlas
