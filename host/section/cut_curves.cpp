#include "cut_curves.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "surface/plane_section.hpp"
#include "surface/round_surface.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFF;

class CurveFinder {
  public:
    CurveFinder(PlaneCut& cut, const PlaneFrame& plane)
        : cut_(cut), mesh_(cut.mesh), plane_(plane), first_number_(mesh_.edge_curves.size()) {
        for (const KnownEdge& edge : mesh_.known_edges)
            first_number_ = std::max(first_number_, std::size_t{edge.edge} + 1);
        first_number_ = std::max(first_number_, mesh_.edge_entities.size());
        for (const SurfaceShape& shape : mesh_.surfaces.shapes)
            shapes_.push_back(plain_shape(shape));
    }

    void find() {
        for (const CutStep& step : cut_.steps) curve_of_step_.push_back(curve_of(step));
        if (curves_.empty()) return;
        move_places();
        for (std::size_t i = 0; i < cut_.steps.size(); ++i)
            if (curve_of_step_[i] != none)
                mesh_.known_edges.push_back({.from = cut_.steps[i].from,
                                             .to = cut_.steps[i].to,
                                             .kind = KnownEdge::Kind::wire,
                                             .edge = number_of(curve_of_step_[i])});
        mesh_.edge_curves.resize(first_number_);
        mesh_.edge_entities.resize(first_number_);
        for (const Curve& curve : curves_) {
            mesh_.edge_curves.emplace_back(curve.ellipse);
            mesh_.edge_entities.push_back(mesh_.surfaces.surfaces[curve.surface].entity);
        }
    }

  private:
    struct Curve {
        std::uint32_t surface;
        EdgeCurve ellipse;
    };

    /// What a place of the cut lies on: a curve, or else the line of a step.
    struct Guide {
        std::uint32_t curve = none;
        glm::dvec3 from{0}, way{0};
    };

    glm::dvec3 at(std::uint32_t position) const { return glm::dvec3{mesh_.positions[position]}; }
    std::uint32_t number_of(std::uint32_t curve) const {
        return static_cast<std::uint32_t>(first_number_ + curve);
    }

    static glm::dvec3 nearest(const EdgeCurve& curve, glm::dvec3 place) {
        const glm::dvec3 out = place - curve.center;
        const glm::dvec2 flat{glm::dot(out, curve.u) / glm::dot(curve.u, curve.u),
                              glm::dot(out, curve.v) / glm::dot(curve.v, curve.v)};
        const glm::dvec2 on = flat / glm::length(flat);
        return curve.center + on.x * curve.u + on.y * curve.v;
    }

    /// Whether both ends of a step are as near to a curve as chords of it that are not long are.
    bool is_along(const CutStep& step, const EdgeCurve& curve) const {
        const double most_off = 0.25 * glm::distance(at(step.from), at(step.to));
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
            if (is_along(step, curves_[curve].ellipse)) return curve;
        const PlacedSurface& placed = mesh_.surfaces.surfaces[surface];
        const std::optional<SurfaceCurve> curve = plane_section(
            shapes_[placed.shape], placed, plane_.origin, plane_.normal, parameters_of(step));
        if (!curve) return none;
        const EdgeCurve ellipse{.center = curve->point, .u = curve->u, .v = curve->v};
        if (!is_along(step, ellipse)) return none;
        known.push_back(static_cast<std::uint32_t>(curves_.size()));
        curves_.push_back({surface, ellipse});
        return known.back();
    }

    glm::dvec2 parameters_of(const CutStep& step) const {
        const glm::uvec3 corners = mesh_.triangles[step.triangle];
        const int corner = corners.x == step.from ? 0 : corners.y == step.from ? 1 : 2;
        return mesh_.surfaces.parameters[step.triangle][static_cast<std::size_t>(corner)];
    }

    void move_places() {
        std::map<std::uint32_t, std::vector<Guide>> guides;
        for (std::size_t i = 0; i < cut_.steps.size(); ++i) {
            const CutStep& step = cut_.steps[i];
            const Guide guide{.curve = curve_of_step_[i],
                              .from = at(step.from),
                              .way = at(step.to) - at(step.from)};
            guides[step.from].push_back(guide);
            guides[step.to].push_back(guide);
        }
        for (const auto& [position, all] : guides)
            if (std::ranges::any_of(all, [](const Guide& one) { return one.curve != none; }))
                mesh_.positions[position] = plane_.placed(met(at(position), all));
        // Where the plane goes through an edge of the file, curves may meet smoothly.
        for (const KnownEdge& edge : mesh_.known_edges)
            for (const std::uint32_t position : {edge.from, edge.to})
                if (guides.contains(position) && edge.edge < mesh_.edge_curves.size() &&
                    mesh_.edge_curves[edge.edge])
                    mesh_.positions[position] =
                        plane_.placed(through(*mesh_.edge_curves[edge.edge], at(position)));
    }

    /// The place nearby where the plane goes through a curve.
    glm::dvec3 through(const EdgeCurve& curve, glm::dvec3 place) const {
        const double u = glm::dot(curve.u, plane_.normal), v = glm::dot(curve.v, plane_.normal);
        const double share = -plane_.distance(curve.center) / std::hypot(u, v);
        if (!(std::abs(share) <= 1)) return place; // the plane is that of the curve, or touches it
        const double top = std::atan2(v, u), aside = std::acos(share);
        const auto at = [&](double angle) {
            return curve.center + std::cos(angle) * curve.u + std::sin(angle) * curve.v;
        };
        const glm::dvec3 one = at(top + aside), other = at(top - aside);
        return glm::distance(one, place) < glm::distance(other, place) ? one : other;
    }

    /// The place nearby where guides meet, by projecting to each in turn; lines first.
    glm::dvec3 met(glm::dvec3 place, std::vector<Guide> guides) const {
        std::ranges::stable_sort(guides, std::greater{}, &Guide::curve);
        constexpr int most_turns = 64;
        for (int turn = 0; turn < most_turns; ++turn) {
            const glm::dvec3 before = place;
            for (const Guide& guide : guides) place = projected(guide, place);
            if (place == before) break;
        }
        return place;
    }

    glm::dvec3 projected(const Guide& guide, glm::dvec3 place) const {
        if (guide.curve != none) return nearest(curves_[guide.curve].ellipse, place);
        const double squared = glm::dot(guide.way, guide.way);
        if (!(squared > 0)) return place;
        return guide.from + glm::dot(place - guide.from, guide.way) / squared * guide.way;
    }

    PlaneCut& cut_;
    Mesh& mesh_;
    const PlaneFrame& plane_;
    std::size_t first_number_;         ///< of edges, after those of the file
    std::vector<SurfaceShape> shapes_; ///< plain ones
    std::vector<Curve> curves_;
    std::map<std::uint32_t, std::vector<std::uint32_t>> curves_of_surface_;
    std::vector<std::uint32_t> curve_of_step_; ///< or none
};

} // namespace

void follow_curves(PlaneCut& cut, const PlaneFrame& plane) {
    CurveFinder{cut, plane}.find();
}

} // namespace lineatlas
