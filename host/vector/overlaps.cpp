#include "overlaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/stretches.hpp"
#include "core/line_pens.hpp"
#include "curves.hpp"
#include "paths.hpp"
#include "segment_grid.hpp"

namespace lineatlas {
namespace {

/// Lines run along each other if they are no farther apart than this, pixels. It is a quarter of a
/// pixel, measured from either of the two.
constexpr double reach = 0.26;
/// Lines at less than this sine to each other (5 degrees) count as parallel, and one of them is
/// removed where they are within reach. However lines are cut, no rest is within reach of another
/// line.
constexpr double parallel_sine = 0.0872;
/// Short lines at less than this sine count as parallel if they are within reach all along.
constexpr double along_sine = 0.5;
/// Shorter overlaps are joints, pixels.
constexpr double shortest_overlap = 0.02;
/// A rest between two overlaps, or of a path with overlaps, is dropped if it is shorter than this,
/// pixels.
constexpr double shortest_rest = 0.5;
constexpr double longest_scrap = 12; ///< pixels
/// A silhouette of a surface touches the edge that it ends on. It may run along that edge this far,
/// pixels. So may an edge of the file beside a line that ends where the edge does: there the pen of
/// a rim changes.
constexpr double longest_touch = 32;

/// By LineKind: crease, boundary, material, silhouette, file, intersection, section, hatching,
/// ridge, valley, tangent, centre, trail.
constexpr std::array<int, LA_KIND_COUNT> kind_rank{3, 2, 4, 5, 0, 6, 1, 10, 8, 9, 7, 12, 11};

struct Line {
    glm::dvec2 a, along; ///< its start and unit direction
    double length;
};

/// The part of `line` that runs along `other`, as pixels from its start.
std::optional<Stretch> part_along(const Line& line, const Line& other) {
    const double sine = line.along.x * other.along.y - line.along.y * other.along.x;
    if (!(std::abs(sine) < along_sine)) return {};
    const double cosine = glm::dot(line.along, other.along);

    // The stretch beside the other line, then as much of it as is within reach.
    const double start = glm::dot(line.a - other.a, other.along);
    const double at_a = -start / cosine;
    const double at_b = (other.length - start) / cosine;
    Stretch stretch{std::max(0.0, std::min(at_a, at_b)),
                    std::min(line.length, std::max(at_a, at_b))};
    if (stretch.to - stretch.from < shortest_overlap) return {};
    const glm::dvec2 normal{-other.along.y, other.along.x};
    const double apart = glm::dot(line.a - other.a, normal);
    const double opening = glm::dot(line.along, normal); // distance gained per pixel
    const auto within = [&](double s) { return std::abs(apart + opening * s) <= reach; };
    if (within(stretch.from) && within(stretch.to)) return stretch;
    if (!(std::abs(sine) < parallel_sine) || opening == 0) return {};
    const double one = (-reach - apart) / opening;
    const double two = (reach - apart) / opening;
    stretch = {std::max(stretch.from, std::min(one, two)),
               std::min(stretch.to, std::max(one, two))};
    if (stretch.to - stretch.from < shortest_overlap) return {};
    return stretch;
}

/// The rest of [0, length] without `covered`, which is sorted.
std::vector<Stretch> rest_of(const std::vector<Stretch>& covered, double length) {
    std::vector<Stretch> rest;
    double from = 0;
    for (const Stretch stretch : covered) {
        if (stretch.from > from) rest.push_back({from, stretch.from});
        from = std::max(from, stretch.to);
    }
    if (from < length) rest.push_back({from, length});
    return rest;
}

double mean_depth(const VectorPath& path) {
    double sum = 0;
    for (const VectorPoint& point : path.points) sum += point.depth;
    return sum / static_cast<double>(path.points.size());
}

/// Whether a path runs along an edge or over a face of exact geometry.
bool is_along_curves(const VectorPath& path) {
    if (path.pieces.empty()) return false;
    const VectorPiece& piece = path.pieces.front();
    return piece.edge != VectorPiece::none || piece.face != VectorPiece::none;
}

/// Whether lines of a kind give way to hidden edges too (ISO 128-2: edges, hidden edges, centre
/// lines).
bool is_beside_edges(LineKind kind) {
    return kind == LineKind::centre || kind == LineKind::trail;
}

/// The rank of a path in the order in which paths claim their places.
struct Claim {
    bool hidden;
    bool inside; ///< of the outline
    bool scrap;  ///< so short that it may be the rest of a line along another one, between chords
                 ///< of two depths
    int kind;
    double depth;
    bool after = false; ///< another line along its curve
    std::size_t path;
    auto operator<=>(const Claim&) const = default;
};

/// Of the lines along one curve, the one with the longest visible part claims its place first.
void join_claims(const std::vector<VectorPath>& paths, std::span<const std::uint32_t> curves,
                 std::vector<Claim>& claims) {
    using Line = std::pair<LineKind, std::uint32_t>; // of an edge
    struct Curve {
        Claim first;
        std::map<Line, double> lengths{};
        Line longest{};
    };
    std::map<std::pair<bool, std::uint32_t>, Curve> seen; // by whether it is hidden, and by number
    const auto line_of = [&](std::size_t i) {
        return Line{paths[i].kind, paths[i].pieces.front().edge};
    };
    const auto is_on_curve = [&](std::size_t i) { return curves[i] != PathCurves::no_curve; };
    for (const Claim& claim : claims) {
        if (!is_on_curve(claim.path)) continue;
        Curve& curve =
            seen.try_emplace({claim.hidden, curves[claim.path]}, Curve{claim}).first->second;
        curve.first = std::min(curve.first, claim);
        curve.lengths[line_of(claim.path)] += length_of(paths[claim.path]);
    }
    for (auto& [number, curve] : seen) {
        const auto longest = std::ranges::max_element(
            curve.lengths, {}, [](const auto& length) { return length.second; });
        curve.longest = longest->first;
    }
    for (Claim& claim : claims) {
        if (!is_on_curve(claim.path)) continue;
        const Curve& curve = seen.at({claim.hidden, curves[claim.path]});
        if (curve.lengths.size() == 1) continue;
        Claim moved = curve.first;
        moved.path = claim.path;
        if (line_of(claim.path) != curve.longest) {
            moved.after = true;
            claim = std::max(claim, moved);
        } else if (!claim.scrap) {
            claim = moved;
        }
    }
}

/// Paths in the order in which they claim their place.
std::vector<std::size_t> claim_order(const std::vector<VectorPath>& paths,
                                     std::span<const std::uint32_t> curves) {
    std::vector<Claim> claims;
    claims.reserve(paths.size());
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const VectorPath& path = paths[i];
        claims.push_back(
            {.hidden = !path.visible || is_beside_edges(path.kind),
             .inside = !path.outline && (can_be_outline(path.kind) || is_beside_edges(path.kind)),
             .scrap = is_along_curves(path) && length_of(path) < longest_scrap,
             .kind = kind_rank[static_cast<std::size_t>(path.kind)],
             .depth = mean_depth(path),
             .path = i});
    }
    if (!curves.empty()) join_claims(paths, curves, claims);
    std::ranges::sort(claims);
    std::vector<std::size_t> order;
    order.reserve(claims.size());
    for (const Claim& claim : claims) order.push_back(claim.path);
    return order;
}

class Overlaps {
  public:
    explicit Overlaps(glm::dvec2 picture) : grid_(picture), end_grid_(picture) {}

    /// Lets a path claim its place, and appends the parts that may be drawn to `result`.
    void claim(VectorPath&& path, std::vector<VectorPath>& result) {
        std::vector<Stretch> covered;
        const std::size_t first = lines_.size();
        middles_.clear();
        double passed = 0;
        for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
            const glm::dvec2 way = path.points[i + 1].at - path.points[i].at;
            const double length = glm::length(way);
            if (!(length > 0)) continue;
            const Line line{path.points[i].at, way / length, length};
            const std::vector<Stretch> own = covered_part(line);
            for (const Stretch free : rest_of(own, length)) add(line, free, passed);
            for (const Stretch stretch : own)
                covered.push_back({passed + stretch.from, passed + stretch.to});
            passed += length;
        }
        if (covered.empty()) return keep(std::move(path), result);
        join_stretches(covered, shortest_rest);
        keep_touching_ends(path, passed, covered);
        if (covered.empty()) return keep(std::move(path), result);
        std::vector<Stretch> kept = rest_of(covered, passed);
        std::erase_if(kept,
                      [](Stretch stretch) { return stretch.to - stretch.from < shortest_rest; });
        forget_dropped(first, kept);
        add_parts(path, covered, kept, passed, result);
    }

  private:
    /// Removes stretches from `covered` that only touch the lines along them.
    void keep_touching_ends(const VectorPath& path, double length, std::vector<Stretch>& covered) {
        if (path.closed || path.pieces.empty()) return;
        const auto touches = [&](const VectorPiece& piece, const VectorPoint& end,
                                 Stretch stretch) {
            if (stretch.to - stretch.from >= longest_touch ||
                3 * (stretch.to - stretch.from) >= length)
                return false;
            return piece.face != KnownSurfaces::none ||
                   (piece.edge != VectorPiece::none && is_joint(end.at, stretch));
        };
        if (covered.front().from < shortest_rest &&
            touches(path.pieces.front(), path.points.front(), covered.front()))
            covered.erase(covered.begin());
        if (!covered.empty() && covered.back().to > length - shortest_rest &&
            touches(path.pieces.back(), path.points.back(), covered.back()))
            covered.pop_back();
    }

    /// Whether a line over `stretch` may end beside drawn ones: where a path ends, or after a
    /// shorter way than a rest at any vertex.
    bool is_joint(glm::dvec2 at, Stretch stretch) {
        constexpr double same_point = 1e-6; // pixels
        const auto is_there = [&](glm::dvec2 place) {
            return glm::distance(place, at) < same_point;
        };
        if (stretch.to - stretch.from >= shortest_rest)
            return std::ranges::any_of(end_grid_.near(at, at, same_point),
                                       [&](std::uint32_t i) { return is_there(ends_[i]); });
        return std::ranges::any_of(grid_.near(at, at, same_point), [&](std::uint32_t i) {
            const Line& line = lines_[i];
            return line.length > 0 &&
                   (is_there(line.a) || is_there(line.a + line.along * line.length));
        });
    }

    std::vector<Stretch> covered_part(const Line& line) {
        std::vector<Stretch> covered;
        const glm::dvec2 end = line.a + line.along * line.length;
        for (const std::uint32_t i : grid_.near(line.a, end, reach)) {
            if (const std::optional<Stretch> stretch = part_along(line, lines_[i])) {
                covered.push_back(*stretch);
            }
        }
        join_stretches(covered, shortest_overlap);
        return covered;
    }

    /// passed: length of the path before the line.
    void add(const Line& line, Stretch part, double passed) {
        if (part.to - part.from < shortest_overlap) return;
        const Line free{line.a + line.along * part.from, line.along, part.to - part.from};
        grid_.insert(free.a, free.a + free.along * free.length,
                     static_cast<std::uint32_t>(lines_.size()));
        lines_.push_back(free);
        middles_.push_back(passed + 0.5 * (part.from + part.to));
    }

    /// Empties the lines from `first` on that are in none of the kept parts. Lines that are not
    /// drawn must cover nothing. Otherwise, where many lines meet, each would take away from the
    /// next.
    void forget_dropped(std::size_t first, const std::vector<Stretch>& kept) {
        auto part = kept.begin();
        for (std::size_t i = first; i < lines_.size(); ++i) {
            const double middle = middles_[i - first];
            while (part != kept.end() && part->to < middle) ++part;
            if (part == kept.end() || middle < part->from) lines_[i].length = 0;
        }
    }

    void add_parts(const VectorPath& path, const std::vector<Stretch>& covered,
                   const std::vector<Stretch>& kept, double length,
                   std::vector<VectorPath>& result) {
        std::vector<VectorPath> parts;
        for (const Stretch stretch : kept) parts.push_back(part_of(path, stretch.from, stretch.to));
        const bool over_seam = path.closed && parts.size() > 1 && covered.front().from > 0 &&
                               covered.back().to < length;
        if (over_seam && parts.front().points.front().at == path.points.front().at &&
            parts.back().points.back().at == path.points.back().at) {
            append(parts.back(), parts.front());
            parts.erase(parts.begin());
        }
        for (VectorPath& part : parts) keep(std::move(part), result);
    }

    /// Appends a path that is drawn.
    void keep(VectorPath&& path, std::vector<VectorPath>& result) {
        if (!path.closed && !path.points.empty())
            for (const VectorPoint* end : {&path.points.front(), &path.points.back()}) {
                end_grid_.insert(end->at, end->at, static_cast<std::uint32_t>(ends_.size()));
                ends_.push_back(end->at);
            }
        result.push_back(std::move(path));
    }

    SegmentGrid grid_, end_grid_;
    std::vector<Line> lines_;      ///< lines that are drawn already
    std::vector<glm::dvec2> ends_; ///< of paths that are drawn already
    std::vector<double> middles_;  ///< middles of the lines of the current path, from its start
};

} // namespace

std::vector<VectorPath> remove_overlaps(std::vector<VectorPath> paths, glm::dvec2 picture,
                                        std::span<const std::uint32_t> curves) {
    Overlaps overlaps{picture};
    std::vector<VectorPath> result;
    result.reserve(paths.size());
    for (const std::size_t i : claim_order(paths, curves))
        overlaps.claim(std::move(paths[i]), result);
    return result;
}

} // namespace lineatlas
