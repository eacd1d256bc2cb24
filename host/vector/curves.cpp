#include "curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_set>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "circle_fitting.hpp"
#include "core/edge_curve.hpp"
#include "core/plane_vectors.hpp"
#include "cubic_fitting.hpp"
#include "edges_by_place.hpp"
#include "mesh_circles.hpp"
#include "paths.hpp"
#include "rim_ends.hpp"
#include "seen_ellipse.hpp"
#include "segment_grid.hpp"
#include "spline_edges.hpp"
#include "surface_outlines.hpp"

namespace lineatlas {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double on_curve = 0.02; ///< pixels
constexpr double longest_step = 0.45 * turn;
constexpr double most_off = 0.01;         ///< of chords, pixels
constexpr double most_off_surface = 0.02; ///< of cubics, from points of a surface
/// The same, of points that have been left out of a mesh's silhouette by 0.05 already.
constexpr double most_off_mesh = 0.05;
constexpr double farthest_end = 40; ///< of what ends within a chord of a silhouette, pixels
constexpr double beside = 0.5;      ///< pixels; remove_overlaps() takes 0.25 at most
constexpr double most_chords = 4;   ///< of an edge that goes on beside a silhouette
constexpr double at_chord = 0.05;   ///< of what ends there, pixels, as simplified paths are off

constexpr std::uint32_t none = EdgesByPlace::none;

double angle_of(glm::dvec2 unrolled) {
    return std::atan2(unrolled.y, unrolled.x);
}

/// Where lines of the model end on the screen.
class PathEnds {
  public:
    PathEnds(const std::vector<VectorPath>& paths, glm::dvec2 size) : grid_(size) {
        for (const VectorPath& path : paths) {
            if (path.closed || path.kind == LineKind::hatching) continue;
            for (const VectorPoint* point : {&path.points.front(), &path.points.back()}) {
                grid_.insert(point->at, point->at, static_cast<std::uint32_t>(ends_.size()));
                ends_.push_back(point->at);
            }
        }
    }

    /// Whether is(end) for one within `reach` of the line from a to b.
    template <class Is>
    bool any_near(glm::dvec2 a, glm::dvec2 b, double reach, const Is& is) {
        return std::ranges::any_of(grid_.near(a, b, reach), [&](std::uint32_t i) {
            return distance_to(ends_[i], a, b) < reach && is(ends_[i]);
        });
    }

  private:
    std::vector<glm::dvec2> ends_;
    SegmentGrid grid_; ///< of `ends_`
};

} // namespace

class PathCurves::Finder {
  public:
    Finder(const LineSet& lines, const Mesh& mesh, const Camera& camera)
        : mesh_(mesh), edges_(mesh), splines_(mesh), circles_of_mesh_(lines),
          clip_from_world_(glm::dmat4{camera.projection} * glm::dmat4{camera.view}),
          size_(camera.size), outlines_(mesh.surfaces, camera.eye(), clip_from_world_, size_) {}

    std::vector<std::uint32_t> joints(const VectorPath& path) {
        const std::vector<Step> steps = steps_of(path);
        std::vector<std::uint32_t> found;
        for (std::uint32_t i = 1; i < steps.size(); ++i)
            if (!go_on(steps[i - 1], steps[i])) found.push_back(i);
        return found;
    }

    /// The ellipse that all steps of a path run along, or null. Circles of meshes do not count.
    const Ellipse* ellipse_of(const VectorPath& path) {
        const std::vector<Step> steps = steps_of(path);
        if (steps.front().is_chord) return nullptr;
        for (std::size_t i = 1; i < steps.size(); ++i)
            if (!go_on(steps[i - 1], steps[i])) return nullptr;
        return steps.front().ellipse;
    }

    /// True if the mesh has curves that paths may be bent along.
    bool knows_curves() const { return !mesh_.edge_curves.empty() || !splines_.empty(); }

    /// Whether bend() divides the chord of a piece.
    bool is_bent(const VectorPath& path, const VectorPiece& piece) const {
        const VectorPoint &a = path.points[piece.point], &b = path.points[piece.point + 1];
        const std::optional<Turn> turn = turn_of(piece.source, a, b);
        return turn && chords_of(*turn, a, b) > 1;
    }

    /// Puts a path onto its curves. Call before points are left out, while each step is one piece.
    void bend(VectorPath& path) const {
        std::vector<VectorPoint> points{path.points.front()};
        std::vector<VectorPiece> pieces;
        const std::size_t last = path.pieces.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            VectorPiece piece = path.pieces[i];
            const VectorPoint &a = path.points[piece.point], &b = path.points[piece.point + 1];
            const std::optional<Turn> turn = turn_of(piece.source, a, b);
            if (turn && i == 0 && !path.closed) points.back() = point_on(*turn, a, b, 0);
            const int count = turn ? chords_of(*turn, a, b) : 1;
            for (int k = 1; k <= count; ++k) {
                piece.point = static_cast<std::uint32_t>(points.size() - 1);
                pieces.push_back(piece);
                const bool inner = k < count || (i == last && !path.closed);
                points.push_back(
                    turn && inner ? point_on(*turn, a, b, static_cast<double>(k) / count) : b);
            }
        }
        path.points = std::move(points);
        path.pieces = std::move(pieces);
    }

    void name(VectorPath& path) const {
        for (VectorPiece& piece : path.pieces) {
            piece.face = surface_of(piece.source);
            if (piece.face != KnownSurfaces::none) {
                piece.entity = mesh_.surfaces.surfaces[piece.face].entity;
                continue;
            }
            piece.edge = edges_.edge_of(piece.source);
            if (piece.edge < mesh_.edge_entities.size())
                piece.entity = mesh_.edge_entities[piece.edge];
        }
    }

    /// Silhouettes end on edges where both turn away from the eye. What is seen of an edge ends
    /// within a chord of there: on its curve it goes on to there, or ends before. So does what one
    /// pen draws of an edge.
    void meet(std::vector<VectorPath>& paths) const {
        std::vector<End> ends;
        for (VectorPath& path : paths) {
            if (!path.visible || path.closed || path.pieces.empty()) continue;
            for (const bool at_end : {false, true}) {
                const VectorPiece& piece = at_end ? path.pieces.back() : path.pieces.front();
                const bool on_surface = surface_of(piece.source) != KnownSurfaces::none;
                const EdgeCurve* const curve =
                    on_surface ? nullptr : curve_of(edges_.edge_of(piece.source));
                if (on_surface || curve != nullptr)
                    ends.push_back({&path, at_end, curve, point_at(path, at_end).at.x});
            }
        }
        std::ranges::sort(ends, {}, &End::x);
        for (const End& silhouette : ends) {
            if (silhouette.curve != nullptr) continue;
            const VectorPoint point = point_at(*silhouette.path, silhouette.at_end);
            const auto first =
                std::ranges::lower_bound(ends, point.at.x - farthest_end, {}, &End::x);
            const auto last =
                std::ranges::upper_bound(ends, point.at.x + farthest_end, {}, &End::x);
            std::vector<std::pair<double, const End*>> ways;
            for (auto one = first; one != last; ++one)
                if (const std::optional<double> way = way_to(*one, silhouette))
                    ways.emplace_back(*way, &*one);
            const auto nearest = std::ranges::min_element(
                ways, {}, [](const auto& way) { return std::abs(way.first); });
            // Where another pen goes on from there, two paths end.
            for (const auto& [way, end] : ways)
                if (std::abs(way - nearest->first) < 1e-9) end_at(*end, way, point);
        }
    }

    glm::dvec2 size() const { return size_; } ///< of the picture, pixels

    /// Whether the mesh has chords of circles.
    bool knows_chords() const { return !circles_of_mesh_.empty(); }

    /// Notes chords that another line runs along, but not along their arc. Such chords stay
    /// straight, so that the line that is drawn for both is near both.
    void note_shared_chords(const std::vector<VectorPath>& paths) {
        std::vector<Leg> legs;
        SegmentGrid grid{size_};
        for (const VectorPath& path : paths) {
            if (path.kind == LineKind::hatching) continue;
            const std::vector<Step> steps = steps_of(path);
            for (std::uint32_t i = 0; i < steps.size(); ++i) {
                const Leg leg{path.points[i].at, path.points[i + 1].at, steps[i], &path, i};
                grid.insert(leg.a, leg.b, static_cast<std::uint32_t>(legs.size()));
                legs.push_back(leg);
            }
        }
        for (const Leg& leg : legs) {
            if (!leg.step.is_chord || off_of(*leg.step.ellipse, leg.middle()) < on_curve) continue;
            const auto is_other = [&](std::uint32_t i) { return runs_beside(leg, legs[i]); };
            if (!std::ranges::any_of(grid.near(leg.a, leg.b, beside), is_other)) continue;
            for (const VectorPiece& piece : leg.path->pieces)
                if (piece.point == leg.point) shared_.insert(piece.segment);
        }
    }

    /// Takes out points within chords, which other triangles have made.
    void join_chords(VectorPath& path) {
        std::vector<std::uint32_t> circles(path.points.size(), MeshCircles::none);
        for (const VectorPiece& piece : path.pieces) circles[piece.point] = circle_of_mesh(piece);
        for (std::size_t i = path.points.size() - 1; i-- > 1;)
            if (circles[i] != MeshCircles::none && circles[i - 1] == circles[i] &&
                is_within_chord(path, i, circles[i]))
                drop_point(path, i);
    }

    /// Where one pen hands over to another within a chord, both end on its arc. Where a line
    /// becomes hidden it ends as the chord does.
    void meet_on_arcs(std::vector<VectorPath>& paths) {
        struct PenEnd {
            VectorPath* path;
            bool at_end;
            std::uint32_t circle;

            auto order() const {
                const VectorPoint& point = point_at(*path, at_end);
                return std::tuple{circle, path->visible, point.at.x, point.at.y};
            }
        };
        std::vector<PenEnd> ends;
        for (VectorPath& path : paths) {
            if (path.closed || path.pieces.empty()) continue;
            for (const bool at_end : {false, true}) {
                const VectorPiece& piece = at_end ? path.pieces.back() : path.pieces.front();
                const std::uint32_t circle = circle_of_mesh(piece);
                if (circle != MeshCircles::none) ends.push_back({&path, at_end, circle});
            }
        }
        std::ranges::sort(ends, {}, &PenEnd::order);
        for (std::size_t i = 1; i < ends.size(); ++i) {
            if (ends[i - 1].order() != ends[i].order()) continue;
            const Ellipse* const ellipse = ellipse_of_mesh(ends[i].circle);
            if (ellipse == nullptr) continue;
            const glm::dvec2 at = ellipse->towards(point_at(*ends[i].path, ends[i].at_end).at);
            for (const PenEnd& end : {ends[i - 1], ends[i]})
                point_at(*end.path, end.at_end).at = at;
        }
    }

    /// Leaves out steps of next to no length, as beside the crossing of two silhouettes. Such a
    /// step would stand between two curves, or have one in two.
    static void drop_short_steps(VectorPath& path) {
        constexpr double no_length = 1e-3; // pixels
        for (std::size_t i = path.points.size() - 1; i-- > 0 && path.points.size() > 3;) {
            if (!(glm::distance(path.points[i].at, path.points[i + 1].at) < no_length)) continue;
            std::erase_if(path.pieces, [&](const VectorPiece& piece) { return piece.point == i; });
            for (VectorPiece& piece : path.pieces)
                if (piece.point > i) --piece.point;
            path.points.erase(path.points.begin() + static_cast<std::ptrdiff_t>(i == 0 ? 1 : i));
        }
    }

    /// Leaves out ends of rims seen edge on that turn back: what is seen of the far half beside the
    /// extreme runs along the near half.
    static void drop_hooks(VectorPath& path) {
        constexpr double longest = 0.5; // pixels
        constexpr double back = -0.99;  // cosine
        if (path.closed || path.pieces.empty()) return;
        for (const bool at_end : {false, true}) {
            const std::vector<VectorPoint>& points = path.points;
            const VectorPiece& piece = at_end ? path.pieces.back() : path.pieces.front();
            if (points.size() < 3 || piece.edge == VectorPiece::none) continue;
            const auto at = [&](std::size_t i) {
                return points[at_end ? points.size() - 1 - i : i].at;
            };
            const glm::dvec2 hook = at(1) - at(0), on = at(2) - at(1);
            const double length = glm::length(hook), whole = length_of(path);
            if (!(length < longest && glm::dot(hook, on) < back * length * glm::length(on)))
                continue;
            const bool thinned = path.thinned;
            path = part_of(path, at_end ? 0 : length, at_end ? whole - length : whole);
            path.thinned = thinned;
        }
    }

    void find(VectorPath& path, PathEnds* ends) {
        std::vector<Step> steps = steps_of(path);
        for (std::size_t i = 0; i < steps.size(); ++i)
            if (steps[i].is_chord && is_met(*steps[i].ellipse, path, i, *ends)) steps[i] = {};
        if (path.closed) {
            begin_between_curves(path, steps);
        } else if (!path.pieces.empty()) {
            reach_extreme(path.pieces.front(), path.points[1].at, path.points.front());
            reach_extreme(path.pieces.back(), path.points[path.points.size() - 2].at,
                          path.points.back());
        }
        for (std::uint32_t first = 0; first < steps.size();) {
            std::uint32_t last = first + 1;
            while (last < steps.size() && go_on(steps[last - 1], steps[last])) ++last;
            if (steps[first].ellipse != nullptr) add(path, steps, first, last);
            first = last;
        }
        add_cubics(path, steps);
    }

  private:
    /// From a point of a path to the next one.
    struct Step {
        std::uint32_t edge = none;
        bool on_surface = false;          ///< a silhouette that lies on a known one
        bool on_mesh = false;             ///< a smooth one of triangles
        bool is_chord = false;            ///< a whole one of a circle of the mesh
        const Ellipse* ellipse = nullptr; ///< that of the edge, or of such a silhouette

        bool is_smooth() const { return on_surface || on_mesh || edge != none; }
        bool is_of_line(const Step& other) const {
            return edge == other.edge && on_surface == other.on_surface && on_mesh == other.on_mesh;
        }
    };

    /// From a point of a path to the next one.
    struct Leg {
        glm::dvec2 a, b;
        Step step;
        const VectorPath* path;
        std::uint32_t point;

        glm::dvec2 middle() const { return 0.5 * (a + b); }
    };

    /// Whether another line is so near to a chord that one of both is drawn, and its arc is
    /// elsewhere.
    static bool runs_beside(const Leg& chord, const Leg& other) {
        const glm::dvec2 way = chord.b - chord.a, along = other.b - other.a;
        const double across = std::abs(cross(way, along));
        if (across > beside * std::max(glm::length(way), glm::length(along))) return false;
        if (distance_to(chord.middle(), other.a, other.b) > beside &&
            distance_to(other.middle(), chord.a, chord.b) > beside)
            return false;
        const Ellipse *own = chord.step.ellipse, *its = other.step.ellipse;
        return its == nullptr || off_of(*own, its->towards(chord.middle())) > on_curve;
    }

    static bool go_on(const Step& a, const Step& b) {
        return a.ellipse == b.ellipse ||
               (a.ellipse != nullptr && b.ellipse != nullptr && a.ellipse->is(*b.ellipse));
    }

    using Ellipses = std::map<std::uint32_t, std::optional<Ellipse>>;

    /// The ellipse of the curve with this number, calculated once. `curve()` returns the curve in
    /// space, if there is one.
    template <class Curve>
    const Ellipse* ellipse_of(Ellipses& known, std::uint32_t number, const Curve& curve) {
        const auto [entry, fresh] = known.try_emplace(number);
        if (fresh)
            if (const std::optional<EdgeCurve> in_space = curve())
                entry->second = Ellipse::seen(*in_space, clip_from_world_, size_);
        return entry->second ? &*entry->second : nullptr;
    }
    const EdgeCurve* curve_of(std::uint32_t edge) const {
        const auto& curves = mesh_.edge_curves;
        return edge < curves.size() && curves[edge] ? &*curves[edge] : nullptr;
    }
    const Ellipse* ellipse_of(std::uint32_t edge) {
        if (curve_of(edge) == nullptr) return nullptr;
        return ellipse_of(ellipses_, edge, [&] { return mesh_.edge_curves[edge]; });
    }
    /// The number of the surface that a silhouette runs over, or KnownSurfaces::none.
    std::uint32_t surface_of(const LineSource& source) const {
        const KnownSurfaces& known = mesh_.surfaces;
        return is_contour(source) && source.triangle < known.of_triangle.size()
                   ? known.of_triangle[source.triangle]
                   : KnownSurfaces::none;
    }
    static bool is_contour(const LineSource& source) {
        return source.from == LineSource::none && source.crossing == LineSource::none &&
               source.triangle != LineSource::none;
    }

    /// The end of a path, of a silhouette on a surface or along an edge's curve.
    struct End {
        VectorPath* path;
        bool at_end;
        const EdgeCurve* curve; ///< null: of a silhouette
        double x;               ///< where it was on the screen
    };

    static VectorPoint& point_at(VectorPath& path, bool at_end) {
        return at_end ? path.points.back() : path.points.front();
    }

    /// The angle from an edge's end to the end of a silhouette on its curve; nothing if that is
    /// farther than its last chord is long. It may be some chords farther where the edge runs so
    /// close beside the silhouette that its chords are not hidden yet.
    std::optional<double> way_to(const End& end, const End& silhouette) const {
        if (end.curve == nullptr) return {};
        const EdgeCurve& curve = *end.curve;
        const VectorPoint& point = point_at(*silhouette.path, silhouette.at_end);
        const VectorPoint& own = point_at(*end.path, end.at_end);
        if (!(glm::distance(own.at, point.at) < farthest_end)) return {};
        const double angle = angle_on(curve, point.world);
        constexpr double rounding = 1e-5;
        const double size = std::max(glm::length(curve.u), glm::length(curve.v));
        if (!(glm::distance(place_on(curve, angle), point.world) < rounding * size)) return {};
        const LineSource& source =
            (end.at_end ? end.path->pieces.back() : end.path->pieces.front()).source;
        const double way = std::remainder(angle - angle_on(curve, own.world), turn);
        const double chords = std::abs(way / chord_of(curve, source));
        if (chords < 1.01 || (chords < most_chords && passes(*silhouette.path, own.at))) return way;
        return {};
    }

    static bool passes(const VectorPath& path, glm::dvec2 at) {
        for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
            if (distance_to(at, path.points[i].at, path.points[i + 1].at) < beside) return true;
        return false;
    }

    /// The angle between the ends of an edge's chord.
    double chord_of(const EdgeCurve& curve, const LineSource& source) const {
        const glm::dvec3 from{mesh_.positions[source.from]}, to{mesh_.positions[source.to]};
        return std::remainder(angle_on(curve, to) - angle_on(curve, from), turn);
    }

    /// Lets a path along a curve end at a place on it, by that angle from where it does.
    void end_at(const End& end, double way, const VectorPoint& point) const {
        VectorPath& path = *end.path;
        if (!end.at_end) reverse(path);
        const VectorPoint before = path.points[path.points.size() - 2];
        const double came = std::remainder(angle_on(*end.curve, path.points.back().world) -
                                               angle_on(*end.curve, before.world),
                                           turn);
        if (way * came > 0) { // on from where it ends
            const VectorPoint from = path.points.back();
            const Turn turn{
                .curve = end.curve, .from = angle_on(*end.curve, from.world), .by = way};
            const int count = chords_of(turn, from, point);
            for (int k = 1; k <= count; ++k) {
                VectorPiece piece = path.pieces.back();
                piece.point = static_cast<std::uint32_t>(path.points.size() - 1);
                path.pieces.push_back(piece);
                path.points.push_back(point_on(turn, from, point, static_cast<double>(k) / count));
            }
        } else {
            const auto is_beyond = [&](const VectorPoint& one) {
                const double to = std::remainder(
                    angle_on(*end.curve, point.world) - angle_on(*end.curve, one.world), turn);
                return to * came <= 0;
            };
            while (path.points.size() > 2 && is_beyond(path.points[path.points.size() - 2])) {
                path.points.pop_back();
                path.pieces.pop_back();
            }
        }
        VectorPoint& last = path.points.back();
        last.at = point.at;
        last.world = point.world;
        last.depth = point.depth;
        last.inverse_w = point.inverse_w;
        if (!end.at_end) reverse(path);
    }

    /// A way along an edge: from where and how far, in angles of its curve or, where it is a
    /// spline, in shares of the chord.
    struct Turn {
        const EdgeCurve* curve;
        const SplineEdges::Span* spline = nullptr;
        double from, by;

        glm::dvec3 place(double share) const {
            const double at = from + share * by;
            return spline != nullptr ? spline->at(at) : place_on(*curve, at);
        }
        double angle() const { return spline != nullptr ? spline->turn * by : by; }
    };

    /// Between two points of a chord; nothing where the chord is not one of the curve.
    std::optional<Turn> turn_of(const LineSource& source, const VectorPoint& a,
                                const VectorPoint& b) const {
        const std::uint32_t piece = edges_.piece_of(source);
        if (const SplineEdges::Span* const spline = splines_.span(piece))
            return spline_turn(*spline, a, b);
        const EdgeCurve* const known =
            piece == none ? nullptr : curve_of(mesh_.known_edges[piece].edge);
        if (known == nullptr) return {};
        const EdgeCurve& curve = *known;
        const double whole = chord_of(curve, source);
        const double size = std::max(glm::length(curve.u), glm::length(curve.v));
        constexpr double rounding = 1e-6;
        const double deep = (1 - std::cos(0.5 * whole) + rounding) * size;
        const double at_a = angle_on(curve, a.world), at_b = angle_on(curve, b.world);
        if (glm::distance(place_on(curve, at_a), a.world) > deep ||
            glm::distance(place_on(curve, at_b), b.world) > deep)
            return {};
        return Turn{.curve = &curve, .from = at_a, .by = std::remainder(at_b - at_a, turn)};
    }

    /// The same of a spline.
    static std::optional<Turn> spline_turn(const SplineEdges::Span& spline, const VectorPoint& a,
                                           const VectorPoint& b) {
        constexpr double rounding = 1e-5;
        const double from = spline.share_of(a.world), to = spline.share_of(b.world);
        const glm::dvec3 chord = spline.to - spline.from;
        const auto is_beside = [&](double share, const VectorPoint& point) {
            return glm::distance(spline.from + share * chord, point.world) <=
                   rounding * (glm::length(chord) + glm::length(spline.from));
        };
        if (!is_beside(from, a) || !is_beside(to, b)) return {};
        return Turn{.curve = nullptr, .spline = &spline, .from = from, .by = to - from};
    }

    static int chords_of(const Turn& turn, const VectorPoint& a, const VectorPoint& b) {
        constexpr double most = 64;
        const double sagitta = glm::distance(a.at, b.at) * std::abs(turn.angle()) / 8;
        return static_cast<int>(std::clamp(std::ceil(std::sqrt(sagitta / most_off)), 1.0, most));
    }

    VectorPoint point_on(const Turn& turn, const VectorPoint& a, const VectorPoint& b,
                         double share) const {
        VectorPoint point;
        point.world = turn.place(share);
        const glm::dvec4 clip = clip_from_world_ * glm::dvec4{point.world, 1};
        point.at = on_screen(point.world);
        point.depth = 0.5 * (1 + clip.z / clip.w);
        point.inverse_w = 1 / clip.w;
        point.arc = std::lerp(a.arc, b.arc, share);
        return point;
    }

    glm::dvec2 on_screen(glm::dvec3 world) const {
        const glm::dvec4 clip = clip_from_world_ * glm::dvec4{world, 1};
        return {0.5 * size_.x * (1 + clip.x / clip.w), 0.5 * size_.y * (1 - clip.y / clip.w)};
    }

    std::vector<Step> steps_of(const VectorPath& path) {
        std::vector<Step> steps(path.points.size() - 1);
        std::vector<bool> known(steps.size(), false);
        for (const VectorPiece& piece : path.pieces) {
            if (piece.point >= steps.size()) continue;
            Step& step = steps[piece.point];
            const std::uint32_t surface = surface_of(piece.source);
            const bool on_surface = surface != KnownSurfaces::none;
            const bool on_mesh = !on_surface && is_contour(piece.source);
            const std::uint32_t edge = on_surface || on_mesh ? none : edges_.edge_of(piece.source);
            const Ellipse* const chord = ellipse_of_chord(path, piece);
            const Ellipse* const ellipse =
                chord != nullptr ? chord
                : on_surface     ? outlines_.between(surface, path.points[piece.point].world,
                                                     path.points[piece.point + 1].world)
                                 : ellipse_of(edge);
            if (!known[piece.point])
                step = {.edge = edge,
                        .on_surface = on_surface,
                        .on_mesh = on_mesh,
                        .is_chord = chord != nullptr,
                        .ellipse = ellipse};
            else if (!go_on(step, {.ellipse = ellipse}))
                step = {.edge = step.edge, .on_surface = step.on_surface, .on_mesh = step.on_mesh};
            known[piece.point] = true;
        }
        return steps;
    }

    /// The circle of the mesh that a piece is a chord of, or MeshCircles::none.
    std::uint32_t circle_of_mesh(const VectorPiece& piece) const {
        return edges_.edge_of(piece.source) != none ? MeshCircles::none
                                                    : circles_of_mesh_.circle_of(piece.segment);
    }
    const Ellipse* ellipse_of_mesh(std::uint32_t number) {
        return ellipse_of(chords_, number, [&] { return circles_of_mesh_.circle(number); });
    }

    /// The circle that a mesh was cut from, for a chord from corner to corner; else null.
    const Ellipse* ellipse_of_chord(const VectorPath& path, const VectorPiece& piece) {
        const std::uint32_t number = circle_of_mesh(piece);
        if (number == MeshCircles::none || shared_.contains(piece.segment)) return nullptr;
        const Ellipse* const ellipse = ellipse_of_mesh(number);
        const auto is_on = [&](std::size_t point) {
            return off_of(*ellipse, path.points[point].at) < on_curve;
        };
        return ellipse != nullptr && is_on(piece.point) && is_on(piece.point + 1) ? ellipse
                                                                                  : nullptr;
    }

    /// Pixels between a point and the ellipse, at most.
    static double off_of(const Ellipse& ellipse, glm::dvec2 at) {
        const glm::dvec2 out = ellipse.unrolled(at);
        const double length = glm::length(out);
        return std::abs(1 - 1 / length) * glm::distance(at, ellipse.arc(0, 0).center);
    }

    /// Whether a line ends on the chord from a point to the next one so far from its arc that it
    /// would no longer meet it.
    static bool is_met(const Ellipse& ellipse, const VectorPath& path, std::size_t point,
                       PathEnds& ends) {
        const auto is_off = [&](glm::dvec2 end) { return off_of(ellipse, end) > on_curve; };
        return ends.any_near(path.points[point].at, path.points[point + 1].at, at_chord, is_off);
    }

    /// Whether a point divides a chord that is straight.
    bool is_within_chord(const VectorPath& path, std::size_t point, std::uint32_t number) {
        const Ellipse* const ellipse = ellipse_of_mesh(number);
        constexpr double rounding = 0.005; // pixels
        return ellipse != nullptr && off_of(*ellipse, path.points[point].at) > on_curve &&
               distance_to(path.points[point].at, path.points[point - 1].at,
                           path.points[point + 1].at) < rounding;
    }

    static void drop_point(VectorPath& path, std::size_t point) {
        const glm::dvec2 a = path.points[point - 1].at, b = path.points[point + 1].at;
        const double share = share_along(path.points[point].at, a, b);
        for (VectorPiece& piece : path.pieces) {
            if (piece.point + 1 < point || piece.point > point) {
                if (piece.point > point) --piece.point;
                continue;
            }
            const double from = piece.point == point ? share : 0, to = from == 0 ? share : 1;
            piece.from = static_cast<float>(std::lerp(from, to, double{piece.from}));
            piece.to = static_cast<float>(std::lerp(from, to, double{piece.to}));
            piece.point = static_cast<std::uint32_t>(point - 1);
        }
        path.points.erase(path.points.begin() + static_cast<std::ptrdiff_t>(point));
    }

    /// A loop that began within a curve would have it in two.
    static void begin_between_curves(VectorPath& path, std::vector<Step>& steps) {
        if (!go_on(steps.back(), steps.front())) return;
        std::size_t first = 1;
        while (first < steps.size() && go_on(steps[first - 1], steps[first])) ++first;
        if (first == steps.size()) return;
        const auto count = static_cast<std::uint32_t>(steps.size());
        const auto by = static_cast<std::ptrdiff_t>(first);
        std::rotate(steps.begin(), steps.begin() + by, steps.end());
        path.points.pop_back();
        std::rotate(path.points.begin(), path.points.begin() + by, path.points.end());
        path.points.push_back(path.points.front());
        const auto begins_behind = std::ranges::find_if(
            path.pieces, [&](const VectorPiece& piece) { return piece.point >= first; });
        std::rotate(path.pieces.begin(), begins_behind, path.pieces.end());
        for (VectorPiece& piece : path.pieces)
            piece.point = (piece.point + count - static_cast<std::uint32_t>(first)) % count;
    }

    /// Moves the end of a path along a curve that is seen edge on, as a straight line. The path
    /// ends on the chord where the curve turns back; the curve itself reaches a little farther.
    void reach_extreme(const VectorPiece& piece, glm::dvec2 before, VectorPoint& end) {
        const std::uint32_t edge = edges_.edge_of(piece.source);
        if (curve_of(edge) == nullptr || ellipse_of(edge) != nullptr) return;
        const EdgeCurve& curve = *curve_of(edge);
        const double chord = std::abs(chord_of(curve, piece.source));
        const double at = angle_on(curve, end.world);
        const glm::dvec2 way = end.at - before;
        if (!(glm::length(way) > 0)) return;
        const glm::dvec2 along = glm::normalize(way);
        const auto beyond = [&](double t) { return on_screen(place_on(curve, t)) - end.at; };
        if (!(glm::length(beyond(at)) < Ellipse::flattest)) return;
        // By thirds: within a chord it goes that way and comes back once.
        double low = at - chord, high = at + chord;
        for (int i = 0; i < 60; ++i) {
            const double a = low + (high - low) / 3, b = high - (high - low) / 3;
            if (glm::dot(beyond(a), along) < glm::dot(beyond(b), along))
                low = a;
            else
                high = b;
        }
        const double extreme = 0.5 * (low + high);
        if (std::abs(extreme - at) > 0.99 * chord) return; // it goes on
        const glm::dvec2 reach = beyond(extreme);
        const double off = cross(reach, along);
        if (!(glm::dot(reach, along) > 0) || !(std::abs(off) < Ellipse::flattest)) return;
        end.at += reach;
        end.world = place_on(curve, extreme);
    }

    /// Adds the curve of the steps from `first` up to `last`, if the points lie on it one after the
    /// other.
    void add(VectorPath& path, const std::vector<Step>& steps, std::uint32_t first,
             std::uint32_t last) const {
        const Ellipse& ellipse = *steps[first].ellipse;
        const bool whole = path.closed && first == 0 && last == steps.size();
        double sweep = 0;
        for (std::uint32_t i = first; i <= last; ++i) {
            const glm::dvec2 here = ellipse.unrolled(path.points[i].at);
            // A path that ends at a chord of another line, as of a section, is put onto its own
            // curve.
            const bool is_end = !path.closed && (i == 0 || i == steps.size());
            const double slack = (is_end ? at_chord : on_curve) / ellipse.minor();
            if (!(std::abs(glm::length(here) - 1) < slack)) return;
            if (i == first) continue;
            const double step = angle_between(ellipse.unrolled(path.points[i - 1].at), here);
            if (!(step * sweep >= 0) || !(std::abs(step) < longest_step) || step == 0) return;
            sweep += step;
        }
        if (whole) sweep = std::copysign(turn, sweep);
        if (!(std::abs(sweep) < turn * (1 + 1e-9))) return;
        const double from = angle_of(ellipse.unrolled(path.points[first].at));
        const VectorArc arc = ellipse.arc(from, sweep);
        path.curves.push_back(
            {.first = first, .last = last, .arc = arc, .edge = steps[first].edge});
        if (path.closed || steps[first].is_chord) return;
        if (first == 0) path.points.front().at = arc.at(from);
        if (last == steps.size()) path.points.back().at = arc.at(from + sweep);
    }

    /// The circle that goes through all points of a closed silhouette, as of a sphere of splines.
    /// Between few points, or points far apart, the silhouette may leave the circle.
    static std::optional<VectorArc> circle_of(std::span<const glm::dvec2> points) {
        constexpr double off = 0.5 * most_off_surface;
        constexpr std::size_t fewest = 12;
        if (points.size() <= fewest) return {}; // the first one is the last one, too
        const std::optional<Circle> circle = fit_circle(points);
        if (!circle) return {};
        double sweep = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (std::abs(circle->distance(points[i])) > off) return {};
            if (i == 0) continue;
            const double step = circle->angle(points[i - 1], points[i]);
            if (!(step * sweep >= 0) || !circle->is_told_by(std::abs(step))) return {};
            sweep += step;
        }
        if (std::abs(std::abs(sweep) - turn) > 0.5 * turn) return {}; // no turn, or several
        const glm::dvec2 start = points.front() - circle->center;
        return VectorArc{.center = circle->center,
                         .major = {circle->radius, 0},
                         .ratio = 1,
                         .from = std::atan2(start.y, start.x),
                         .sweep = std::copysign(turn, sweep)};
    }

    /// Adds cubics along the steps that are smooth and no arc.
    static void add_cubics(VectorPath& path, const std::vector<Step>& steps) {
        std::vector<VectorCurve> curves;
        auto arc = path.curves.begin();
        const auto count = static_cast<std::uint32_t>(steps.size());
        for (std::uint32_t first = 0; first < count;) {
            if (arc != path.curves.end() && arc->first == first) {
                first = arc->last;
                curves.push_back(*arc++);
                continue;
            }
            const std::uint32_t end = arc != path.curves.end() ? arc->first : count;
            std::uint32_t last = first + 1;
            while (last < end && steps[last].is_of_line(steps[first])) ++last;
            if (steps[first].is_smooth()) {
                std::vector<glm::dvec2> points;
                for (std::uint32_t i = first; i <= last; ++i) points.push_back(path.points[i].at);
                const bool whole = path.closed && first == 0 && last == count;
                const bool on_mesh = steps[first].on_mesh;
                const auto circle =
                    whole && steps[first].on_surface ? circle_of(points) : std::nullopt;
                if (circle) {
                    curves.push_back(
                        {.first = first, .last = last, .arc = *circle, .edge = steps[first].edge});
                    break;
                }
                for (const FittedCubic& one :
                     fit_cubics(points, whole, on_mesh ? most_off_mesh : most_off_surface))
                    curves.push_back({.first = first + one.first,
                                      .last = first + one.last,
                                      .cubic = one.cubic,
                                      .edge = steps[first].edge});
            }
            first = last;
        }
        path.curves = std::move(curves);
    }

    const Mesh& mesh_;
    EdgesByPlace edges_;
    SplineEdges splines_;
    MeshCircles circles_of_mesh_;
    glm::dmat4 clip_from_world_;
    glm::dvec2 size_;
    Ellipses ellipses_; ///< of edges
    Ellipses chords_;   ///< of circles of the mesh
    SurfaceOutlines outlines_;
    /// Segments that stay straight: chords of such circles.
    std::unordered_set<std::uint32_t> shared_;
};

PathCurves::PathCurves(const LineSet& lines, const Mesh* mesh, const Camera& camera) {
    if (mesh != nullptr) finder_ = std::make_unique<Finder>(lines, *mesh, camera);
}

PathCurves::~PathCurves() = default;

void PathCurves::bend(std::vector<VectorPath>& paths) const {
    if (!finder_ || !finder_->knows_curves()) return;
    const RimEnds ends{paths, finder_->size(),
                       [&](const VectorPath& path, const VectorPiece& piece) {
                           return finder_->is_bent(path, piece);
                       }};
    for (VectorPath& path : paths)
        if (!path.pieces.empty()) finder_->bend(path);
    finder_->meet(paths);
    ends.move(paths);
}

void PathCurves::name(std::vector<VectorPath>& paths) const {
    if (!finder_) return;
    for (VectorPath& path : paths) finder_->name(path);
}

std::vector<std::uint32_t> PathCurves::numbers(const std::vector<VectorPath>& paths) const {
    if (!finder_ || !finder_->knows_curves()) return {};
    struct Seen {
        double x; ///< of the centre
        const Ellipse* ellipse;
        std::uint32_t path;
    };
    std::vector<Seen> seen;
    for (std::uint32_t i = 0; i < paths.size(); ++i)
        if (const Ellipse* const ellipse = finder_->ellipse_of(paths[i]))
            seen.push_back({ellipse->arc(0, 0).center.x, ellipse, i});
    std::ranges::sort(seen, {}, [](const Seen& one) { return std::pair{one.x, one.path}; });
    constexpr double rounding = 0.01; // pixels, more than Ellipse::is() allows
    std::vector<std::uint32_t> result(paths.size(), no_curve);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        std::uint32_t number = seen[i].path;
        for (std::size_t k = i; k-- > 0 && seen[i].x - seen[k].x < rounding;) {
            if (!seen[i].ellipse->is(*seen[k].ellipse)) continue;
            number = result[seen[k].path];
            break;
        }
        result[seen[i].path] = number;
    }
    return result;
}

void PathCurves::keep_shared_chords(const std::vector<VectorPath>& paths) const {
    if (finder_ && finder_->knows_chords()) finder_->note_shared_chords(paths);
}

std::vector<std::uint32_t> PathCurves::joints(const VectorPath& path) const {
    return finder_ ? finder_->joints(path) : std::vector<std::uint32_t>{};
}

void PathCurves::find(std::vector<VectorPath>& paths) const {
    if (!finder_) return;
    std::optional<PathEnds> ends; // needed for chords alone
    if (finder_->knows_chords()) {
        for (VectorPath& path : paths) finder_->join_chords(path);
        finder_->meet_on_arcs(paths);
        ends.emplace(paths, finder_->size());
    }
    for (VectorPath& path : paths) {
        if (finder_->knows_curves()) {
            Finder::drop_short_steps(path);
            Finder::drop_hooks(path);
        }
        finder_->find(path, ends ? &*ends : nullptr);
    }
}

} // namespace lineatlas
