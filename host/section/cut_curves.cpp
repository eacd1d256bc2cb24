#include "cut_curves.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "core/edge_curve.hpp"
#include "surface/plane_section.hpp"
#include "surface/round_surface.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;

class CurveFinder {
  public:
    CurveFinder(PlaneCut& cut, const PlaneFrame& plane)
        : cut_(cut), mesh_(cut.mesh), plane_(plane), plain_shapes_(mesh_.surfaces.shapes.size()) {}

    void find() {
        for (const CutStep& step : cut_.steps) curve_of_step_.push_back(curve_of(step));
        if (curves_.empty()) return;
        move_places();
        number_curves();
        for (const CurveSteps& steps : steps_of_curves())
            for (const std::uint32_t i : steps)
                mesh_.known_edges.push_back({.from = cut_.steps[i].from,
                                             .to = cut_.steps[i].to,
                                             .kind = KnownEdge::Kind::wire,
                                             .edge = curves_[curve_of_step_[i]].number});
    }

  private:
    struct Curve {
        std::uint32_t surface;
        std::optional<EdgeCurve> ellipse; ///< nothing: the curve is known by its places alone
        std::uint32_t number = none;      ///< of its edge
    };

    /// What a place of the cut lies on: a curve, or else the line of a step.
    struct Guide {
        std::uint32_t curve = none;
        glm::dvec3 from{0}, way{0};
        std::optional<glm::dvec2> parameters{}; ///< of the place on the curve's surface
    };

    glm::dvec3 at(std::uint32_t position) const { return glm::dvec3{mesh_.positions[position]}; }

    /// Gives curves numbers that no edge has. Files may number theirs as they like.
    void number_curves() {
        std::set<std::uint32_t> taken;
        for (const KnownEdge& edge : mesh_.known_edges) taken.insert(edge.edge);
        std::size_t number = std::max(mesh_.edge_curves.size(), mesh_.edge_entities.size());
        for (Curve& curve : curves_) {
            while (taken.contains(static_cast<std::uint32_t>(number))) ++number;
            curve.number = static_cast<std::uint32_t>(number++);
            mesh_.edge_curves.resize(number);
            mesh_.edge_entities.resize(number);
            mesh_.edge_curves.back() = curve.ellipse;
            mesh_.edge_entities.back() = mesh_.surfaces.surfaces[curve.surface].entity;
        }
    }

    /// The place of an ellipse in the direction of another from its centre.
    static glm::dvec3 nearest(const EdgeCurve& curve, glm::dvec3 place) {
        const glm::dvec2 out = glm::normalize(unrolled(curve, place - curve.center));
        return curve.center + out.x * curve.u + out.y * curve.v;
    }

    double longest_side(std::uint32_t triangle) const {
        const glm::uvec3 t = mesh_.triangles[triangle];
        return std::max({glm::distance(at(t.x), at(t.y)), glm::distance(at(t.y), at(t.z)),
                         glm::distance(at(t.z), at(t.x))});
    }

    /// Whether both ends of a step are as near to a curve as triangles of its size are.
    bool is_along(const CutStep& step, const EdgeCurve& curve) const {
        const double most_off = 0.25 * longest_side(step.triangle);
        return glm::distance(nearest(curve, at(step.from)), at(step.from)) < most_off &&
               glm::distance(nearest(curve, at(step.to)), at(step.to)) < most_off;
    }

    std::uint32_t curve_of(const CutStep& step) {
        if (mesh_.surfaces.empty()) return none;
        const std::uint32_t surface = mesh_.surfaces.of_triangle[step.triangle];
        if (surface == KnownSurfaces::none) return none;
        // A plane may cut a surface in two curves, as a torus.
        std::vector<std::uint32_t>& known = curves_of_surface_[surface];
        for (const std::uint32_t curve : known)
            if (!curves_[curve].ellipse || is_along(step, *curves_[curve].ellipse)) return curve;
        const PlacedSurface& placed = mesh_.surfaces.surfaces[surface];
        const std::optional<glm::dvec2> parameters = parameters_at(step, step.from);
        if (!parameters) return none;
        const std::optional<SurfaceCurve> curve =
            plane_section(mesh_.surfaces.shapes[placed.shape], plain_of(placed.shape), placed,
                          plane_.origin, plane_.normal, *parameters);
        std::optional<EdgeCurve> ellipse;
        if (curve) {
            ellipse = {.center = curve->point, .u = curve->u, .v = curve->v};
            if (!is_along(step, *ellipse)) return none;
        }
        known.push_back(static_cast<std::uint32_t>(curves_.size()));
        curves_.push_back({surface, ellipse});
        return known.back();
    }

    const SurfaceShape& plain_of(std::uint32_t shape) {
        std::optional<SurfaceShape>& plain = plain_shapes_[shape];
        if (!plain) plain = plain_shape(mesh_.surfaces.shapes[shape]);
        return *plain;
    }

    /// The parameters of an end of a step. Nothing if the triangle was too small to be kept.
    std::optional<glm::dvec2> parameters_at(const CutStep& step, std::uint32_t position) const {
        const std::size_t end = std::min<std::size_t>(step.triangle + 2, mesh_.triangles.size());
        for (std::size_t i = step.triangle; i < end; ++i)
            for (int corner = 0; corner < 3; ++corner)
                if (mesh_.triangles[i][corner] == position &&
                    mesh_.surfaces.of_triangle[i] == mesh_.surfaces.of_triangle[step.triangle])
                    return mesh_.surfaces.parameters[i][static_cast<std::size_t>(corner)];
        return std::nullopt;
    }

    using CurveSteps = std::vector<std::uint32_t>;

    /// The steps of every curve, each behind the one that ends where it begins.
    std::vector<CurveSteps> steps_of_curves() const {
        std::vector<CurveSteps> result(curves_.size());
        for (std::uint32_t i = 0; i < cut_.steps.size(); ++i)
            if (curve_of_step_[i] != none) result[curve_of_step_[i]].push_back(i);
        for (std::size_t i = 0; i < curves_.size(); ++i)
            if (!curves_[i].ellipse) result[i] = in_order(result[i]);
        return result;
    }

    CurveSteps in_order(const CurveSteps& steps) const {
        std::map<std::uint32_t, std::uint32_t> by_start;
        std::set<std::uint32_t> ends;
        for (const std::uint32_t i : steps) {
            by_start.emplace(cut_.steps[i].from, i);
            ends.insert(cut_.steps[i].to);
        }
        CurveSteps result;
        const auto follow = [&](std::uint32_t position) {
            for (auto next = by_start.find(position); next != by_start.end();
                 next = by_start.find(cut_.steps[result.back()].to)) {
                result.push_back(next->second);
                by_start.erase(next);
            }
        };
        for (const std::uint32_t i : steps)
            if (!ends.contains(cut_.steps[i].from)) follow(cut_.steps[i].from);
        while (!by_start.empty()) follow(by_start.begin()->first); // loops
        return result;
    }

    /// What the cut follows at each place, and how far the place may be moved along the plane.
    struct Guides {
        std::vector<Guide> all;
        double reach = 0;
    };

    void move_places() {
        std::map<std::uint32_t, Guides> places;
        for (std::size_t i = 0; i < cut_.steps.size(); ++i) {
            const CutStep& step = cut_.steps[i];
            Guide guide{.curve = curve_of_step_[i],
                        .from = at(step.from),
                        .way = at(step.to) - at(step.from)};
            for (const std::uint32_t position : {step.from, step.to}) {
                if (guide.curve != none) guide.parameters = parameters_at(step, position);
                Guides& guides = places[position];
                guides.reach = std::max(guides.reach, 0.25 * longest_side(step.triangle));
                if (guide.curve != none || !is_of_curves(step)) guides.all.push_back(guide);
            }
        }
        for (auto& [position, guides] : places)
            move(position, met(at(position), guides.all), guides);
        // Where the plane goes through an edge of the file, curves may meet smoothly.
        for (const KnownEdge& edge : mesh_.known_edges)
            for (const std::uint32_t position : {edge.from, edge.to})
                if (places.contains(position) && edge.edge < mesh_.edge_curves.size() &&
                    mesh_.edge_curves[edge.edge])
                    move(position, through(*mesh_.edge_curves[edge.edge], at(position)),
                         places[position]);
    }

    /// Whether the plane cuts the surface of a step in a curve elsewhere, so that the step is a
    /// chord and no line.
    bool is_of_curves(const CutStep& step) const {
        const auto found = curves_of_surface_.find(mesh_.surfaces.of_triangle[step.triangle]);
        return found != curves_of_surface_.end() && !found->second.empty();
    }

    void move(std::uint32_t position, std::optional<glm::dvec3> to, const Guides& guides) {
        const bool is_on_curve =
            std::ranges::any_of(guides.all, [](const Guide& one) { return one.curve != none; });
        if (is_on_curve && to && glm::distance(*to, at(position)) < guides.reach)
            mesh_.positions[position] = plane_.placed(*to);
    }

    /// The place nearby where two guides meet, or the nearest one on the curve if all are one, or
    /// if two meet smoothly.
    std::optional<glm::dvec3> met(glm::dvec3 place, std::span<const Guide> guides) const {
        const auto first =
            std::ranges::find_if(guides, [](const Guide& one) { return one.curve != none; });
        if (first == guides.end()) return std::nullopt;
        const auto other = std::ranges::find_if(
            guides, [&](const Guide& one) { return one.curve != first->curve; });
        std::optional<glm::dvec3> result;
        if (other != guides.end()) result = crossing(*first, *other, place);
        return result ? result : nearest(*first, place);
    }

    std::optional<glm::dvec3> nearest(const Guide& guide, glm::dvec3 place) const {
        const Curve& curve = curves_[guide.curve];
        if (curve.ellipse) return nearest(*curve.ellipse, place);
        if (!guide.parameters) return std::nullopt;
        const PlacedSurface& placed = mesh_.surfaces.surfaces[curve.surface];
        return place_on_plane(mesh_.surfaces.shapes[placed.shape], placed, plane_.origin,
                              plane_.normal, *guide.parameters);
    }

    /// The place nearby where a curve and another guide cross.
    std::optional<glm::dvec3> crossing(const Guide& curve, const Guide& other,
                                       glm::dvec3 place) const {
        const std::optional<EdgeCurve>& ellipse = curves_[curve.curve].ellipse;
        if (other.curve == none) {
            if (ellipse) return on_line(*ellipse, other.from, other.way, place);
            if (!curve.parameters) return std::nullopt;
            const PlacedSurface& placed = mesh_.surfaces.surfaces[curves_[curve.curve].surface];
            return place_on_line(mesh_.surfaces.shapes[placed.shape], placed, other.from, other.way,
                                 *curve.parameters);
        }
        const std::optional<EdgeCurve>& its = curves_[other.curve].ellipse;
        return ellipse && its ? crossing(*ellipse, *its, place) : std::nullopt;
    }

    /// The place of an ellipse on a line, the nearer one of two.
    static std::optional<glm::dvec3> on_line(const EdgeCurve& curve, glm::dvec3 from,
                                             glm::dvec3 way, glm::dvec3 place) {
        const glm::dvec2 p = unrolled(curve, from - curve.center), d = unrolled(curve, way);
        const double a = glm::dot(d, d), b = glm::dot(p, d), c = glm::dot(p, p) - 1;
        const double root = std::sqrt(b * b - a * c);
        if (!(root >= 0) || !(a > 0)) return std::nullopt;
        const glm::dvec3 one = from + (-b - root) / a * way, two = from + (-b + root) / a * way;
        return glm::distance(one, place) < glm::distance(two, place) ? one : two;
    }

    /// The place where two ellipses cross, by Newton's method.
    std::optional<glm::dvec3> crossing(const EdgeCurve& a, const EdgeCurve& b,
                                       glm::dvec3 place) const {
        for (int i = 0; i < 16; ++i) {
            const glm::dvec2 at_a = unrolled(a, place - a.center),
                             at_b = unrolled(b, place - b.center);
            const glm::dvec2 off{glm::dot(at_a, at_a) - 1, glm::dot(at_b, at_b) - 1};
            const auto change = [&](const EdgeCurve& curve, glm::dvec2 at) {
                return 2.0 * glm::dvec2{glm::dot(at, unrolled(curve, plane_.u)),
                                        glm::dot(at, unrolled(curve, plane_.v))};
            };
            const glm::dvec2 by_a = change(a, at_a), by_b = change(b, at_b);
            const double turn = by_a.x * by_b.y - by_a.y * by_b.x;
            constexpr double smooth = 0.02; // sine of the angle between curves that do not cross
            if (!(std::abs(turn) > smooth * glm::length(by_a) * glm::length(by_b)))
                return std::nullopt;
            const glm::dvec2 step =
                glm::dvec2{by_b.y * off.x - by_a.y * off.y, by_a.x * off.y - by_b.x * off.x} / turn;
            place -= step.x * plane_.u + step.y * plane_.v;
        }
        return place;
    }

    /// The place nearby where the plane goes through a curve. None if it only touches it.
    std::optional<glm::dvec3> through(const EdgeCurve& curve, glm::dvec3 place) const {
        const double u = glm::dot(curve.u, plane_.normal), v = glm::dot(curve.v, plane_.normal);
        const double share = -plane_.distance(curve.center) / std::hypot(u, v);
        if (!(std::abs(share) <= 1)) return std::nullopt;
        const double top = std::atan2(v, u), aside = std::acos(share);
        const glm::dvec3 one = place_on(curve, top + aside), other = place_on(curve, top - aside);
        return glm::distance(one, place) < glm::distance(other, place) ? one : other;
    }

    PlaneCut& cut_;
    Mesh& mesh_;
    const PlaneFrame& plane_;
    std::vector<std::optional<SurfaceShape>> plain_shapes_; ///< of those that the plane cuts
    std::vector<Curve> curves_;
    std::map<std::uint32_t, std::vector<std::uint32_t>> curves_of_surface_;
    std::vector<std::uint32_t> curve_of_step_; ///< or none
};

} // namespace

void follow_curves(PlaneCut& cut, const PlaneFrame& plane) {
    CurveFinder{cut, plane}.find();
}

} // namespace lineatlas
