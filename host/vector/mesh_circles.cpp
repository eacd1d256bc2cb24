#include "mesh_circles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "circle_fitting.hpp"
#include "core/plane_vectors.hpp"

namespace lineatlas {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double most_turn = 15.1 * degree; ///< of 24 chords, and rounding
constexpr double straight = 0.01 * degree;  ///< chords of a circle turn by more
constexpr double least_sweep = 30 * degree;
constexpr std::size_t fewest_chords = 4;
constexpr std::size_t most_at_vertex = 16; ///< chords that a vertex over which one goes on may have
constexpr double most_off = 5e-4;          ///< of the radius

constexpr LineKindMask kinds = mask_of(LineKind::crease) | mask_of(LineKind::boundary) |
                               mask_of(LineKind::material) | mask_of(LineKind::file) |
                               mask_of(LineKind::section);

/// The segments that may be chords, and how one goes on into another.
class Graph {
  public:
    explicit Graph(const LineSet& lines) : lines_(lines), first_(lines.vertices.size() + 1, 0) {
        for (std::uint32_t i = 0; i < lines.segments.size(); ++i)
            if (is_chord(lines.segments[i])) chords_.push_back(i);
        for (const std::uint32_t i : chords_)
            for (const std::uint32_t end : {lines.segments[i].p, lines.segments[i].q})
                ++first_[end + 1];
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        at_.resize(2 * chords_.size());
        std::vector<std::uint32_t> next = first_;
        for (const std::uint32_t i : chords_)
            for (const std::uint32_t end : {lines.segments[i].p, lines.segments[i].q})
                at_[next[end]++] = i;
    }

    const std::vector<std::uint32_t>& chords() const { return chords_; }

    std::uint32_t other_end(std::uint32_t segment, std::uint32_t vertex) const {
        const Segment& s = lines_.segments[segment];
        return s.p == vertex ? s.q : s.p;
    }

    /// The segment in which a line goes on beyond the end of one; nothing where several meet.
    std::optional<std::uint32_t> next(std::uint32_t segment, std::uint32_t end) const {
        const std::optional<std::uint32_t> found = after(segment, end);
        return found && after(*found, end) == segment ? found : std::nullopt;
    }

    glm::dvec3 place(std::uint32_t vertex) const { return lines_.vertices[vertex]; }

  private:
    bool is_chord(const Segment& segment) const {
        const auto kind = static_cast<LineKind>(segment.tag & LA_TAG_KIND_MASK);
        return (mask_of(kind) & kinds) != 0 && segment.p != segment.q;
    }

    /// Each chord at a vertex is compared with all others there. The tip of a fan of many chords
    /// would cost the square of their number, so no chord goes on over it.
    std::optional<std::uint32_t> after(std::uint32_t segment, std::uint32_t end) const {
        const auto here = std::span{at_}.subspan(first_[end], first_[end + 1] - first_[end]);
        if (here.size() > most_at_vertex) return {};
        const glm::dvec3 way = place(end) - place(other_end(segment, end));
        for (const std::uint32_t other : here) {
            const glm::dvec3 on = place(other_end(other, end)) - place(end);
            if (other != segment && glm::dot(way, on) > 0 &&
                glm::length(glm::cross(way, on)) < straight * glm::length(way) * glm::length(on))
                return other;
        }
        if (here.size() != 2) return {};
        return here[0] == segment ? here[1] : here[0];
    }

    const LineSet& lines_;
    std::vector<std::uint32_t> chords_;
    std::vector<std::uint32_t> first_; ///< of `at_`, per vertex
    std::vector<std::uint32_t> at_;    ///< segments
};

/// A straight way from one corner to the next.
struct Chord {
    std::vector<std::uint32_t> segments;
    glm::dvec3 from, to;

    glm::dvec3 way() const { return to - from; }
    double length() const { return glm::length(way()); }
};

/// The axis of a turn from one way to another, as long as the angle.
glm::dvec3 turn_between(const Chord& a, const Chord& b) {
    const glm::dvec3 across = glm::cross(a.way(), b.way());
    const double sine = glm::length(across);
    if (!(sine > 0)) return glm::dvec3{0};
    return std::atan2(sine, glm::dot(a.way(), b.way())) / sine * across;
}

/// Chords in a row.
struct Chain {
    std::vector<Chord> chords;
    bool closed = false;
};

class Chains {
  public:
    Chains(const LineSet& lines, const Graph& graph)
        : graph_(graph), lines_(lines), is_taken_(lines.segments.size(), false) {}

    /// The one that a segment is a part of; empty if it was found before.
    Chain take(std::uint32_t segment) {
        if (is_taken_[segment]) return {};
        std::vector<std::uint32_t> segments;
        std::uint32_t begin = lines_.segments[segment].p;
        const bool closed = follow(segment, lines_.segments[segment].q, segments);
        if (!closed) { // from its end once more, the other way
            std::vector<std::uint32_t> before;
            const std::uint32_t last = segments.back();
            for (const std::uint32_t each : segments) is_taken_[each] = false;
            begin = end_;
            follow(last, graph_.other_end(last, end_), before);
            segments = std::move(before);
        }
        return chain_of(segments, begin, closed);
    }

  private:
    /// Segments from one on, away from its other end; whether they come back to it.
    bool follow(std::uint32_t segment, std::uint32_t end, std::vector<std::uint32_t>& segments) {
        const std::uint32_t start = segment;
        while (true) {
            is_taken_[segment] = true;
            segments.push_back(segment);
            end_ = end;
            const std::optional<std::uint32_t> next = graph_.next(segment, end);
            if (next == start && segments.size() > 1) return true;
            if (!next || is_taken_[*next]) return false;
            segment = *next;
            end = graph_.other_end(segment, end);
        }
    }

    Chain chain_of(const std::vector<std::uint32_t>& segments, std::uint32_t begin, bool closed) {
        Chain chain{.chords = {}, .closed = closed};
        for (const std::uint32_t segment : segments) {
            const std::uint32_t end = graph_.other_end(segment, begin);
            Chord chord{{segment}, graph_.place(begin), graph_.place(end)};
            begin = end;
            if (!chain.chords.empty() && goes_on(chain.chords.back(), chord))
                join(chain.chords.back(), chord);
            else
                chain.chords.push_back(std::move(chord));
        }
        if (closed && chain.chords.size() > 2 && goes_on(chain.chords.back(), chain.chords[0])) {
            join(chain.chords.back(), chain.chords[0]);
            chain.chords.erase(chain.chords.begin());
        }
        return chain;
    }

    static bool goes_on(const Chord& a, const Chord& b) {
        return glm::length(turn_between(a, b)) < straight;
    }
    static void join(Chord& chord, const Chord& next) {
        chord.to = next.to;
        chord.segments.insert(chord.segments.end(), next.segments.begin(), next.segments.end());
    }

    const Graph& graph_;
    const LineSet& lines_;
    std::vector<bool> is_taken_;
    std::uint32_t end_ = 0; ///< where following ended
};

/// Chords of one circle. In a loop the last ones may be its first ones again.
struct Arc {
    std::size_t first, end; ///< of Chain::chords
    EdgeCurve circle;
};

class ArcsOfChain {
  public:
    explicit ArcsOfChain(const Chain& chain)
        : chain_(chain), count_(chain.chords.size()), arc_of_(count_, none) {}

    std::vector<Arc> find() {
        std::vector<Arc> arcs;
        const std::size_t begin = chain_.closed ? first_break() : 0;
        for (std::size_t first = begin; first + fewest_chords <= begin + count_;) {
            const std::size_t end = end_of_equals(first, begin + count_);
            std::optional<Arc> arc;
            if (end - first >= fewest_chords) arc = arc_of(first, end);
            if (arc) {
                take_ends(*arc);
                for (std::size_t i = arc->first; i < arc->end; ++i)
                    arc_of_[i % count_] = arcs.size();
                arcs.push_back(*arc);
            }
            first = arc ? end : std::max(first + 1, end - 1);
        }
        std::vector<Arc> kept;
        for (const Arc& arc : arcs)
            if (!bends_on(arcs, arc, true) && !bends_on(arcs, arc, false)) kept.push_back(arc);
        return kept;
    }

    /// Chord i of the chain; in a loop the first chord follows the last one.
    const Chord& chord(std::size_t i) const { return chain_.chords[i % count_]; }

  private:
    /// Whether chord `at` + 1 is as long as chord `first` and turns as the chord behind `first`
    /// does, within what errors of the corners allow.
    bool is_equal(std::size_t first, std::size_t at) const {
        const glm::dvec3 turn = turn_between(chord(first), chord(first + 1));
        const double angle = glm::length(turn), length = chord(first).length();
        if (!(angle < most_turn)) return false;
        const double off = most_off * length / (2 * std::sin(0.5 * angle));
        return std::abs(chord(at + 1).length() - length) < 4 * off &&
               glm::distance(turn_between(chord(at), chord(at + 1)), turn) < 8 * off / length;
    }

    /// One past the last of consecutive chords that are equal to chord `first`.
    std::size_t end_of_equals(std::size_t first, std::size_t limit) const {
        std::size_t end = first + 1;
        while (end < limit && !is_taken(end) && is_equal(first, end - 1)) ++end;
        return end;
    }

    /// The first chord of a loop that is unlike the chord before it; 0 if all are alike.
    std::size_t first_break() const {
        for (std::size_t i = 0; i < count_; ++i)
            if (!is_equal(i + count_ - 2, i + count_ - 1)) return i;
        return 0;
    }

    std::optional<Arc> arc_of(std::size_t first, std::size_t end) const {
        const bool whole = chain_.closed && end - first == count_;
        std::vector<glm::dvec3> corners{chord(first).from};
        for (std::size_t i = first; i < end; ++i) corners.push_back(chord(i).to);
        if (whole) corners.pop_back();
        const std::optional<EdgeCurve> circle = circle_through(corners);
        if (!circle) return {};
        Arc arc{.first = first, .end = end, .circle = *circle};
        double sweep = 0;
        for (std::size_t i = first; i < end; ++i) {
            const double angle = angle_of(arc, chord(i));
            if (!(angle > 0) || !is_on(arc, chord(i).from) || !is_on(arc, chord(i).to)) return {};
            sweep += angle;
        }
        const bool is_long = sweep > least_sweep && (whole || sweep < 2 * std::numbers::pi);
        return is_long ? std::optional{arc} : std::nullopt;
    }

    static std::optional<EdgeCurve> circle_through(std::span<const glm::dvec3> corners) {
        glm::dvec3 mean{0}, area{0};
        for (const glm::dvec3& corner : corners) mean += corner;
        mean /= static_cast<double>(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i)
            area += glm::cross(corners[i] - mean, corners[(i + 1) % corners.size()] - mean);
        const glm::dvec3 axis = glm::normalize(area);
        const glm::dvec3 out = corners[0] - mean;
        const glm::dvec3 u = glm::normalize(out - glm::dot(out, axis) * axis);
        const glm::dvec3 v = glm::cross(axis, u);
        std::vector<glm::dvec2> flat;
        for (const glm::dvec3& corner : corners)
            flat.emplace_back(glm::dot(corner - mean, u), glm::dot(corner - mean, v));
        const std::optional<Circle> circle = fit_circle(flat);
        if (!circle) return {};
        return EdgeCurve{.center = mean + circle->center.x * u + circle->center.y * v,
                         .u = circle->radius * u,
                         .v = circle->radius * v};
    }

    static glm::dvec2 in_plane(const Arc& arc, glm::dvec3 place) {
        const glm::dvec3 out = place - arc.circle.center;
        return {glm::dot(out, arc.circle.u), glm::dot(out, arc.circle.v)};
    }

    /// Seen from the centre; below 0 if the chord goes the other way round.
    static double angle_of(const Arc& arc, const Chord& chord) {
        return angle_between(in_plane(arc, chord.from), in_plane(arc, chord.to));
    }

    static bool is_on(const Arc& arc, glm::dvec3 place) {
        const double radius = glm::length(arc.circle.u);
        const glm::dvec3 out = place - arc.circle.center;
        const glm::dvec2 flat = in_plane(arc, place) / radius;
        const double above = std::sqrt(std::max(0.0, glm::dot(out, out) - glm::dot(flat, flat)));
        return std::hypot(glm::length(flat) - radius, above) < most_off * radius;
    }

    /// Where an arc ends between two corners, its last chord is shorter.
    void take_ends(Arc& arc) const {
        const double whole = 1.001 * angle_of(arc, chord(arc.first));
        const auto is_part = [&](std::size_t i) {
            const double angle = angle_of(arc, chord(i));
            return !is_taken(i) && is_on(arc, chord(i).from) && is_on(arc, chord(i).to) &&
                   angle > 0 && angle < whole;
        };
        if (const auto before = beside(arc, false, 1); before && is_part(*before)) {
            if (arc.first == 0) arc.end += count_; // once round
            arc.first = arc.first == 0 ? count_ - 1 : arc.first - 1;
        }
        if (const auto behind = beside(arc, true, 1); behind && is_part(*behind)) ++arc.end;
    }

    /// The chord that stands `by` chords before or behind an arc, if there is one.
    std::optional<std::size_t> beside(const Arc& arc, bool behind, std::size_t by) const {
        if (arc.end - arc.first + by > count_) return {};
        if (behind && (chain_.closed || arc.end + by <= count_)) return arc.end + by - 1;
        if (!behind && (chain_.closed || arc.first >= by))
            return (arc.first + count_ - by) % count_;
        return {};
    }

    /// Whether the line bends on beyond an arc: parts of ellipses and spirals resemble arcs.
    bool bends_on(const std::vector<Arc>& arcs, const Arc& arc, bool behind) const {
        const Chord& regular = chord((arc.first + arc.end) / 2);
        const double turn = angle_of(arc, regular);
        const glm::dvec3 axis = glm::normalize(glm::cross(arc.circle.u, arc.circle.v));
        std::size_t last = behind ? arc.end - 1 : arc.first;
        for (std::size_t by = 1; by <= 2; ++by) {
            const std::optional<std::size_t> next = beside(arc, behind, by);
            if (!next || (by == 2 && is_taken(*next))) return false;
            const glm::dvec3 bend = behind ? turn_between(chord(last), chord(*next))
                                           : turn_between(chord(*next), chord(last));
            const double share = glm::dot(bend, axis) / turn;
            const double size = chord(*next).length() / regular.length();
            if (!(share > 0.3) || !(share < 3) || !(size < 3)) return false;
            if (is_taken(*next)) return is_alike(arc, arcs[arc_of_[*next % count_]]);
            last = *next;
        }
        return true;
    }

    static bool is_alike(const Arc& a, const Arc& b) {
        const double ratio = glm::length(a.circle.u) / glm::length(b.circle.u);
        return ratio < 1.5 && ratio > 1 / 1.5;
    }

    bool is_taken(std::size_t i) const { return arc_of_[i % count_] != none; }

    static constexpr std::size_t none = ~std::size_t{0};

    const Chain& chain_;
    std::size_t count_;
    std::vector<std::size_t> arc_of_; ///< per chord, or `none`
};

} // namespace

MeshCircles::MeshCircles(const LineSet& lines) {
    const Graph graph{lines};
    Chains chains{lines, graph};
    for (const std::uint32_t segment : graph.chords()) {
        const Chain chain = chains.take(segment);
        if (chain.chords.size() < fewest_chords) continue;
        ArcsOfChain arcs{chain};
        for (const Arc& arc : arcs.find()) {
            circle_of_.resize(lines.segments.size(), none);
            for (std::size_t i = arc.first; i < arc.end; ++i)
                for (const std::uint32_t part : arcs.chord(i).segments)
                    circle_of_[part] = static_cast<std::uint32_t>(circles_.size());
            circles_.push_back(arc.circle);
        }
    }
}

} // namespace lineatlas
