#include "cut_faces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "core/plane_vectors.hpp"
#include "holes.hpp"
#include "polygon/polygon.hpp"

namespace lineatlas {
namespace {

double area_of(std::span<const glm::dvec2> points) {
    double twice = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        twice += cross(points[i], points[(i + 1) % points.size()]);
    }
    return 0.5 * twice;
}

/// The steps of one part, joined to loops.
class LoopFinder {
  public:
    LoopFinder(std::span<const CutStep> steps, const std::vector<glm::vec3>& positions,
               const PlaneFrame& plane)
        : steps_(steps), positions_(positions), plane_(plane), used_(steps.size(), false) {
        for (std::uint32_t i = 0; i < steps.size(); ++i) {
            at_[steps[i].from].push_back(i);
            at_[steps[i].to].push_back(i);
        }
    }

    /// The places at which a way ends.
    std::set<std::uint32_t> ends() const {
        std::set<std::uint32_t> found;
        for (const auto& [place, steps] : at_)
            if (steps.size() % 2 == 1) found.insert(place);
        return found;
    }

    std::vector<CutLoop> loops() {
        std::vector<CutLoop> found;
        for (std::uint32_t i = 0; i < steps_.size(); ++i) {
            if (used_[i]) continue;
            CutLoop loop = walk(i);
            if (loop.points.size() > 2) found.push_back(std::move(loop));
        }
        return found;
    }

  private:
    glm::dvec2 flat(std::uint32_t place) const { return plane_.flat(positions_[place]); }

    CutLoop walk(std::uint32_t first) {
        CutLoop loop;
        const std::uint32_t start = steps_[first].from;
        std::uint32_t before = start, here = steps_[first].to;
        used_[first] = true;
        loop.points.push_back(start);
        while (here != start) {
            loop.points.push_back(here);
            const std::uint32_t next = next_step(before, here);
            // This never happens, because every place has an even number of steps.
            if (next == none) break;
            used_[next] = true;
            before = here;
            const std::uint32_t from = steps_[next].from;
            here = from == here ? steps_[next].to : from;
        }
        for (const std::uint32_t point : loop.points) loop.flat.push_back(flat(point));
        loop.area = area_of(loop.flat);
        return loop;
    }

    /// The step on from place `here`, to which the way came from `before`. Steps in their own
    /// direction come first, and of these the one farthest to the left, so that ways that only
    /// touch in a corner stay apart.
    std::uint32_t next_step(std::uint32_t before, std::uint32_t here) const {
        std::uint32_t best = none;
        double best_rank = -1;
        const glm::dvec2 came = flat(here) - flat(before);
        for (const std::uint32_t i : at_.at(here)) {
            if (used_[i]) continue;
            const bool forwards = steps_[i].from == here;
            const glm::dvec2 goes = flat(forwards ? steps_[i].to : steps_[i].from) - flat(here);
            const double turn = angle_between(came, goes);
            const double rank = (forwards ? 10 : 0) + turn + 4;
            if (rank <= best_rank) continue;
            best = i;
            best_rank = rank;
        }
        return best;
    }

    static constexpr std::uint32_t none = 0xFFFFFFFF;

    std::span<const CutStep> steps_;
    const std::vector<glm::vec3>& positions_;
    const PlaneFrame& plane_;
    std::vector<bool> used_;
    std::map<std::uint32_t, std::vector<std::uint32_t>> at_; ///< steps per place
};

/// Keeps one of the steps between the same two places if their number is odd, and none if it is
/// even. If it is even, an edge of the surface only touches the plane. A surface with a second side
/// upon it has every step in both directions.
std::vector<CutStep> single_steps(std::span<const CutStep> steps) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> counts;
    for (const CutStep& step : steps) ++counts[std::minmax(step.from, step.to)];
    const bool is_sheet = std::ranges::all_of(steps, &CutStep::two_sided);
    std::vector<CutStep> single;
    for (const CutStep& step : steps) {
        std::size_t& count = counts[std::minmax(step.from, step.to)];
        if ((is_sheet ? count / 2 : count) % 2 == 1) single.push_back(step);
        count = 0;
    }
    return single;
}

/// A part whose steps do not close.
struct OpenPart {
    std::vector<CutStep> steps;
    std::set<std::uint32_t> ends; ///< places
};

/// Joins open parts whose ways end at the same places. Files may name pieces of one surface as
/// objects of their own.
void join_open_parts(std::vector<OpenPart>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t k = i + 1; k < parts.size();) {
            std::set<std::uint32_t>& ends = parts[i].ends;
            const auto meets = [&](std::uint32_t end) { return ends.contains(end); };
            if (!std::ranges::any_of(parts[k].ends, meets)) {
                ++k;
                continue;
            }
            std::ranges::copy(parts[k].steps, std::back_inserter(parts[i].steps));
            for (const std::uint32_t end : parts[k].ends)
                if (!ends.insert(end).second) ends.erase(end); // the way goes on there
            parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
            k = i + 1; // parts before it may meet the joined part
        }
    }
}

double area_of(const CutFace& face) {
    double area = 0;
    for (const CutLoop& loop : face.loops) area += loop.area;
    return area;
}

bool holds(const CutFace& face, glm::dvec2 at) {
    return std::ranges::count_if(face.loops, [&](const CutLoop& loop) { return loop.holds(at); }) %
               2 ==
           1;
}

/// Gives hollows to the faces around them. A hollow is connected to nothing and goes round the
/// other way.
void adopt_hollows(std::vector<CutFace>& faces) {
    std::vector<double> areas;
    double sum = 0;
    for (const CutFace& face : faces) sum += areas.emplace_back(area_of(face));
    const double sign = sum < 0 ? -1 : 1; // -1 for a model that is inside out
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> around(faces.size(), none);
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (sign * areas[i] >= 0) continue;
        const glm::dvec2 at = faces[i].loops.front().flat.front();
        for (std::size_t k = 0; k < faces.size(); ++k) {
            if (!(sign * areas[k] > 0) || !holds(faces[k], at)) continue;
            if (around[i] == none || std::abs(areas[k]) < std::abs(areas[around[i]])) around[i] = k;
        }
    }
    std::vector<CutFace> kept;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (around[i] != none)
            std::ranges::copy(faces[i].loops, std::back_inserter(faces[around[i]].loops));
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (around[i] == none) kept.push_back(std::move(faces[i]));
    faces = std::move(kept);
}

/// The number of other loops that a loop lies in. Loops of one face do not cross, so any point of
/// the loop will do.
std::size_t depth_of(const CutFace& face, std::size_t loop) {
    const glm::dvec2 at = 0.5 * (face.loops[loop].flat[0] + face.loops[loop].flat[1]);
    std::size_t depth = 0;
    for (std::size_t i = 0; i < face.loops.size(); ++i)
        if (i != loop && face.loops[i].holds(at)) ++depth;
    return depth;
}

Ring ring_of(const CutLoop& loop, bool counter_clockwise) {
    Ring ring;
    for (std::size_t i = 0; i < loop.points.size(); ++i)
        ring.push_back({loop.flat[i], loop.points[i]});
    if ((loop.area > 0) != counter_clockwise) std::ranges::reverse(ring);
    return ring;
}

} // namespace

bool CutLoop::holds(glm::dvec2 at) const {
    bool inside = false;
    for (std::size_t i = 0; i < flat.size(); ++i) {
        const glm::dvec2 a = flat[i], b = flat[(i + 1) % flat.size()];
        if ((a.y > at.y) == (b.y > at.y)) continue;
        if (a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x) > at.x) inside = !inside;
    }
    return inside;
}

CutFaces find_faces(const PlaneCut& cut, const PlaneFrame& plane) {
    const std::vector<glm::vec3>& positions = cut.mesh.positions;
    std::map<std::uint32_t, std::vector<CutStep>> of_part;
    for (const CutStep& step : cut.steps) of_part[step.part].push_back(step);
    CutFaces found;
    std::vector<OpenPart> open;
    for (const auto& [part, all] : of_part) {
        std::vector<CutStep> steps = single_steps(all);
        LoopFinder finder{steps, positions, plane};
        std::set<std::uint32_t> ends = finder.ends();
        if (!ends.empty()) {
            open.push_back({std::move(steps), std::move(ends)});
        } else if (std::vector<CutLoop> loops = finder.loops(); !loops.empty()) {
            found.closed.push_back({part, steps.front().triangle, std::move(loops)});
        }
    }
    join_open_parts(open);
    for (const OpenPart& part : open) {
        const CutStep& first = part.steps.front();
        LoopFinder finder{part.steps, positions, plane};
        if (!part.ends.empty()) {
            found.gaps.push_back({first.part, positions[*part.ends.begin()], part.ends.size()});
            std::ranges::copy(part.steps, std::back_inserter(found.open));
        } else if (std::vector<CutLoop> loops = finder.loops(); !loops.empty()) {
            found.closed.push_back({first.part, first.triangle, std::move(loops)});
        }
    }
    adopt_hollows(found.closed);
    return found;
}

std::vector<glm::uvec3> face_triangles(const CutFace& face,
                                       const std::vector<glm::vec3>& positions) {
    std::vector<glm::uvec3> triangles;
    std::vector<std::size_t> depths;
    for (std::size_t i = 0; i < face.loops.size(); ++i) depths.push_back(depth_of(face, i));
    for (std::size_t i = 0; i < face.loops.size(); ++i) {
        if (depths[i] % 2 == 1) continue;
        std::vector<Ring> holes;
        for (std::size_t k = 0; k < face.loops.size(); ++k) {
            const CutLoop& hole = face.loops[k];
            if (depths[k] == depths[i] + 1 &&
                face.loops[i].holds(0.5 * (hole.flat[0] + hole.flat[1])))
                holes.push_back(ring_of(hole, false));
        }
        std::vector<std::uint32_t> polygon;
        for (const RingPoint& point : bridged(ring_of(face.loops[i], true), std::move(holes)))
            polygon.push_back(point.position);
        triangulate(positions, polygon, triangles);
    }
    return triangles;
}

} // namespace lineatlas
