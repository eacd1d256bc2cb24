#include "curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "core/pair_key.hpp"

namespace lineatlas {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double flattest = 0.5;    ///< half the shorter axis, pixels
constexpr double on_curve = 0.02;   ///< pixels
constexpr double as_circle = 1e-3;  ///< pixels by which the axes of one may differ
constexpr double same_curve = 1e-3; ///< pixels
constexpr double longest_step = 0.45 * turn;

constexpr std::uint32_t none = 0xFFFFFFFF;

/// What a circle or an ellipse in space looks like on the screen. Its dual conic is that of the
/// unit circle under the map from it to the screen (Hartley and Zisserman, "Multiple View Geometry
/// in Computer Vision", 2004, result 8.6 for duals), from which its centre and axes can be read.
class Ellipse {
  public:
    static std::optional<Ellipse> seen(const EdgeCurve& curve, const glm::dmat4& clip_from_world,
                                       glm::dvec2 size) {
        const auto on_screen = [&](glm::dvec3 at, double w) {
            const glm::dvec4 clip = clip_from_world * glm::dvec4{at, w};
            return glm::dvec3{0.5 * size.x * (clip.x + clip.w), 0.5 * size.y * (clip.w - clip.y),
                              clip.w};
        };
        glm::dvec3 u = on_screen(curve.u, 0), v = on_screen(curve.v, 0);
        glm::dvec3 c = on_screen(curve.center, 1);
        if (!(c.z > 0)) return {};
        // Beside its centre no digits are lost.
        const glm::dvec2 beside = glm::dvec2{c} / c.z;
        for (glm::dvec3* column : {&u, &v, &c}) *column -= glm::dvec3{beside * column->z, 0};
        const auto dual = [&](int i, int k) { return u[i] * u[k] + v[i] * v[k] - c[i] * c[k]; };
        const double scale = -dual(2, 2);
        if (!(scale > 0)) return {}; // reaches behind the eye
        const glm::dvec2 center = -glm::dvec2{dual(0, 2), dual(1, 2)} / scale;
        const double xx = dual(0, 0) / scale + center.x * center.x;
        const double xy = dual(0, 1) / scale + center.x * center.y;
        const double yy = dual(1, 1) / scale + center.y * center.y;
        const double half = std::hypot(0.5 * (xx - yy), xy);
        const double major = std::sqrt(0.5 * (xx + yy) + half);
        const double minor = std::sqrt(std::max(0.0, xx * yy - xy * xy)) / major;
        if (!(minor >= flattest) || !std::isfinite(major)) return {};
        Ellipse result;
        result.arc_.center = beside + center;
        if (major - minor < as_circle) {
            result.arc_.major = {0.5 * (major + minor), 0};
        } else {
            const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
            result.arc_.major = major * glm::dvec2{std::cos(angle), std::sin(angle)};
            result.arc_.ratio = minor / major;
        }
        return result;
    }

    /// The arc from one angle on.
    VectorArc arc(double from, double sweep) const {
        VectorArc result = arc_;
        result.from = from;
        result.sweep = sweep;
        return result;
    }

    /// Where the ellipse is the unit circle.
    glm::dvec2 unrolled(glm::dvec2 at) const {
        const double squared = glm::dot(arc_.major, arc_.major);
        const glm::dvec2 out = at - arc_.center;
        return {glm::dot(out, arc_.major) / squared,
                glm::dot(out, glm::dvec2{-arc_.major.y, arc_.major.x}) / (squared * arc_.ratio)};
    }

    double minor() const { return arc_.ratio * glm::length(arc_.major); }

    bool is(const Ellipse& other) const {
        return glm::distance(arc_.center, other.arc_.center) < same_curve &&
               std::abs(minor() - other.minor()) < same_curve &&
               std::min(glm::distance(arc_.major, other.arc_.major),
                        glm::distance(arc_.major, -other.arc_.major)) < same_curve;
    }

  private:
    VectorArc arc_;
};

double angle_of(glm::dvec2 unrolled) {
    return std::atan2(unrolled.y, unrolled.x);
}

/// From one to the other the shorter way round.
double angle_between(glm::dvec2 a, glm::dvec2 b) {
    return std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
}

/// The file's edges by the places of their ends, of which a position of the mesh may be a copy.
class EdgesByPlace {
  public:
    explicit EdgesByPlace(const Mesh& mesh) : mesh_(mesh) {
        for (const KnownEdge& edge : mesh.known_edges) {
            if (edge.edge >= mesh.edge_curves.size() || !mesh.edge_curves[edge.edge]) continue;
            const std::uint32_t from = places_.emplace(place(edge.from), edge.from).first->second;
            const std::uint32_t to = places_.emplace(place(edge.to), edge.to).first->second;
            edges_.emplace(pair_key(from, to), edge.edge);
        }
    }

    /// The number of the edge that a segment is a part of, or `none`.
    std::uint32_t edge_of(const LineSource& source) const {
        if (source.from >= mesh_.positions.size() || source.to >= mesh_.positions.size())
            return none;
        const auto from = places_.find(place(source.from)), to = places_.find(place(source.to));
        if (from == places_.end() || to == places_.end()) return none;
        const auto found = edges_.find(pair_key(from->second, to->second));
        return found == edges_.end() ? none : found->second;
    }

  private:
    using Place = std::array<float, 3>;
    struct Hash {
        std::size_t operator()(const Place& at) const {
            std::size_t result = 0;
            for (const float x : at) result = result * 0x9E3779B97F4A7C15U + std::hash<float>{}(x);
            return result;
        }
    };

    Place place(std::uint32_t position) const {
        const glm::vec3 at = mesh_.positions[position];
        return {at.x, at.y, at.z};
    }

    const Mesh& mesh_;
    std::unordered_map<Place, std::uint32_t, Hash> places_;
    std::unordered_map<std::uint64_t, std::uint32_t> edges_;
};

} // namespace

class PathCurves::Finder {
  public:
    Finder(const Mesh& mesh, const Camera& camera)
        : mesh_(mesh), edges_(mesh),
          clip_from_world_(glm::dmat4{camera.projection} * glm::dmat4{camera.view}),
          size_(camera.size) {}

    std::vector<std::uint32_t> joints(const VectorPath& path) {
        const std::vector<Step> steps = steps_of(path);
        std::vector<std::uint32_t> found;
        for (std::uint32_t i = 1; i < steps.size(); ++i)
            if (!go_on(steps[i - 1], steps[i])) found.push_back(i);
        return found;
    }

    void find(VectorPath& path) {
        std::vector<Step> steps = steps_of(path);
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
    }

  private:
    /// From a point of a path to the next one.
    struct Step {
        std::uint32_t edge = none;
        const Ellipse* ellipse = nullptr; ///< that of the edge
    };

    static bool go_on(const Step& a, const Step& b) {
        return a.ellipse == b.ellipse ||
               (a.ellipse != nullptr && b.ellipse != nullptr && a.ellipse->is(*b.ellipse));
    }

    const Ellipse* ellipse_of(std::uint32_t edge) {
        const auto [entry, fresh] = ellipses_.try_emplace(edge);
        if (fresh) entry->second = Ellipse::seen(*mesh_.edge_curves[edge], clip_from_world_, size_);
        return entry->second ? &*entry->second : nullptr;
    }

    glm::dvec2 on_screen(glm::dvec3 world) const {
        const glm::dvec4 clip = clip_from_world_ * glm::dvec4{world, 1};
        return {0.5 * size_.x * (1 + clip.x / clip.w), 0.5 * size_.y * (1 - clip.y / clip.w)};
    }

    /// The angle between the ends of a segment.
    double chord_of(const LineSource& source, const Ellipse& ellipse) const {
        const auto at = [&](std::uint32_t position) {
            return ellipse.unrolled(on_screen(glm::dvec3{mesh_.positions[position]}));
        };
        return std::abs(angle_between(at(source.from), at(source.to)));
    }

    std::vector<Step> steps_of(const VectorPath& path) {
        std::vector<Step> steps(path.points.size() - 1);
        std::vector<bool> known(steps.size(), false);
        for (const VectorPiece& piece : path.pieces) {
            if (piece.point >= steps.size()) continue;
            Step& step = steps[piece.point];
            const std::uint32_t edge = edges_.edge_of(piece.source);
            const Ellipse* const ellipse = edge == none ? nullptr : ellipse_of(edge);
            if (!known[piece.point])
                step = {.edge = edge, .ellipse = ellipse};
            else if (!go_on(step, {.ellipse = ellipse}))
                step.ellipse = nullptr;
            known[piece.point] = true;
        }
        return steps;
    }

    /// A loop that began within a curve would have it in two.
    static void begin_between_curves(VectorPath& path, std::vector<Step>& steps) {
        if (!go_on(steps.back(), steps.front())) return;
        std::size_t first = 1;
        while (first < steps.size() && go_on(steps[first - 1], steps[first])) ++first;
        if (first == steps.size()) return;
        const auto count = static_cast<std::uint32_t>(steps.size());
        const auto by = static_cast<std::ptrdiff_t>(first);
        std::ranges::rotate(steps, steps.begin() + by);
        path.points.pop_back();
        std::ranges::rotate(path.points, path.points.begin() + by);
        path.points.push_back(path.points.front());
        const auto begins_behind = std::ranges::find_if(
            path.pieces, [&](const VectorPiece& piece) { return piece.point >= first; });
        std::ranges::rotate(path.pieces, begins_behind);
        for (VectorPiece& piece : path.pieces)
            piece.point = (piece.point + count - static_cast<std::uint32_t>(first)) % count;
    }

    /// Of a curve seen edge on, a straight line, the end of a path: on the chord where it turns
    /// away from the eye, a little before the end of the curve itself.
    void reach_extreme(const VectorPiece& piece, glm::dvec2 before, VectorPoint& end) {
        const std::uint32_t edge = edges_.edge_of(piece.source);
        if (edge == none || ellipse_of(edge) != nullptr) return;
        const EdgeCurve& curve = *mesh_.edge_curves[edge];
        const auto angle = [&](glm::dvec3 world) {
            const glm::dvec3 out = world - curve.center;
            return std::atan2(glm::dot(out, curve.v) / glm::dot(curve.v, curve.v),
                              glm::dot(out, curve.u) / glm::dot(curve.u, curve.u));
        };
        const auto world = [&](double t) {
            return curve.center + std::cos(t) * curve.u + std::sin(t) * curve.v;
        };
        const auto position = [&](std::uint32_t i) { return glm::dvec3{mesh_.positions[i]}; };
        const double from = angle(position(piece.source.from));
        const double chord =
            std::abs(std::remainder(angle(position(piece.source.to)) - from, turn));
        const double at = angle(end.world);
        const glm::dvec2 way = end.at - before;
        if (!(glm::length(way) > 0)) return;
        const glm::dvec2 along = glm::normalize(way);
        const auto beyond = [&](double t) { return on_screen(world(t)) - end.at; };
        if (!(glm::length(beyond(at)) < flattest)) return;
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
        const double off = reach.x * along.y - reach.y * along.x;
        if (!(glm::dot(reach, along) > 0) || !(std::abs(off) < flattest)) return;
        end.at += reach;
        end.world = world(extreme);
    }

    /// The curve of the steps from `first` up to `last`, if its points are on it, one after the
    /// other.
    void add(VectorPath& path, const std::vector<Step>& steps, std::uint32_t first,
             std::uint32_t last) const {
        const Ellipse& ellipse = *steps[first].ellipse;
        const bool whole = path.closed && first == 0 && last == steps.size();
        double sweep = 0;
        for (std::uint32_t i = first; i <= last; ++i) {
            const glm::dvec2 here = ellipse.unrolled(path.points[i].at);
            const double slack = on_curve / ellipse.minor();
            // A path's own ends are where the line disappears, anywhere on a chord.
            double least = 1;
            if (!path.closed && (i == 0 || i == steps.size())) {
                const VectorPiece& end = i == 0 ? path.pieces.front() : path.pieces.back();
                least = std::cos(0.5 * chord_of(end.source, ellipse));
            }
            if (!(glm::length(here) > least - slack) || !(glm::length(here) < 1 + slack)) return;
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
        if (path.closed) return;
        if (first == 0) path.points.front().at = arc.at(from);
        if (last == steps.size()) path.points.back().at = arc.at(from + sweep);
    }

    const Mesh& mesh_;
    EdgesByPlace edges_;
    glm::dmat4 clip_from_world_;
    glm::dvec2 size_;
    std::map<std::uint32_t, std::optional<Ellipse>> ellipses_; ///< of edges
};

PathCurves::PathCurves(const Mesh* mesh, const Camera& camera) {
    if (mesh != nullptr && !mesh->edge_curves.empty())
        finder_ = std::make_unique<Finder>(*mesh, camera);
}

PathCurves::~PathCurves() = default;

std::vector<std::uint32_t> PathCurves::joints(const VectorPath& path) const {
    return finder_ ? finder_->joints(path) : std::vector<std::uint32_t>{};
}

void PathCurves::find(std::vector<VectorPath>& paths) const {
    if (!finder_) return;
    for (VectorPath& path : paths) finder_->find(path);
}

glm::dvec2 VectorArc::at(double angle) const {
    const glm::dvec2 minor = ratio * glm::dvec2{-major.y, major.x};
    return center + std::cos(angle) * major + std::sin(angle) * minor;
}

} // namespace lineatlas
