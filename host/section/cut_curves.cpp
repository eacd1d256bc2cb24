#include "cut_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/edge_curve.hpp"
#include "core/pair_key.hpp"
#include "core/plane_vectors.hpp"
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
        if (mesh_.surfaces.empty()) return;
        for (const CutStep& step : cut_.steps) curve_of_step_.push_back(known_curve_of(step));
        // What is none of these is not known before all of them are.
        for (std::size_t i = 0; i < cut_.steps.size(); ++i)
            if (curve_of_step_[i] == none) curve_of_step_[i] = other_curve_of(cut_.steps[i]);
        if (curves_.empty()) return;
        move_places();
        divide_steps();
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
        bool is_straight = false;
        std::optional<EdgeCurve> ellipse{}; ///< nothing: lines, or known by its places alone
        std::uint32_t number = none;        ///< of its edge

        bool is_of_places() const { return !ellipse && !is_straight; }
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

    std::uint32_t surface_of(const CutStep& step) const {
        return mesh_.surfaces.of_triangle[step.triangle];
    }

    /// The ellipse or the lines that a step runs along.
    std::uint32_t known_curve_of(const CutStep& step) {
        const std::uint32_t surface = surface_of(step);
        if (surface == KnownSurfaces::none) return none;
        if (const std::uint32_t curve = ellipse_along(step); curve != none) return curve;
        const PlacedSurface& placed = mesh_.surfaces.surfaces[surface];
        const SurfaceShape& plain = plain_of(placed.shape);
        if (is_cut_straight(plain, placed, plane_.origin, plane_.normal)) {
            for (const std::uint32_t curve : curves_of_surface_[surface])
                if (curves_[curve].is_straight) return curve;
            return add_curve({.surface = surface, .is_straight = true});
        }
        const std::optional<glm::dvec2> parameters = parameters_at(step, step.from);
        if (!parameters) return none;
        const std::optional<SurfaceCurve> curve =
            plane_section(mesh_.surfaces.shapes[placed.shape], plain, placed, plane_.origin,
                          plane_.normal, *parameters);
        if (!curve) return none;
        const EdgeCurve ellipse{.center = curve->point, .u = curve->u, .v = curve->v};
        return is_along(step, ellipse) ? add_curve({.surface = surface, .ellipse = ellipse}) : none;
    }

    /// A plane may cut a surface in two ellipses, as a torus.
    std::uint32_t ellipse_along(const CutStep& step) {
        for (const std::uint32_t curve : curves_of_surface_[surface_of(step)])
            if (curves_[curve].ellipse && is_along(step, *curves_[curve].ellipse)) return curve;
        return none;
    }

    /// The ellipse that a step runs along though none was found from there, or else the curve that
    /// is known by its places alone.
    std::uint32_t other_curve_of(const CutStep& step) {
        const std::uint32_t surface = surface_of(step);
        if (surface == KnownSurfaces::none || !parameters_at(step, step.from)) return none;
        if (const std::uint32_t curve = ellipse_along(step); curve != none) return curve;
        for (const std::uint32_t curve : curves_of_surface_[surface])
            if (curves_[curve].is_of_places()) return curve;
        return add_curve({.surface = surface});
    }

    std::uint32_t add_curve(const Curve& curve) {
        const auto number = static_cast<std::uint32_t>(curves_.size());
        curves_.push_back(curve);
        curves_of_surface_[curve.surface].push_back(number);
        return number;
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
        std::multimap<std::uint32_t, std::uint32_t> by_start;
        std::set<std::uint32_t> ends;
        for (const std::uint32_t i : steps) {
            by_start.emplace(cut_.steps[i].from, i);
            ends.insert(cut_.steps[i].to);
        }
        CurveSteps result;
        const auto follow = [&](std::uint32_t position) {
            auto next = by_start.find(position);
            while (next != by_start.end()) {
                const std::uint32_t step = next->second;
                result.push_back(step);
                by_start.erase(next);
                // Where the curve crosses itself, it goes straight on.
                const auto [first, last] = by_start.equal_range(cut_.steps[step].to);
                next = std::max_element(first, last, [&](const auto& one, const auto& other) {
                    return straightness(step, one.second) < straightness(step, other.second);
                });
                if (first == last) next = by_start.end();
            }
        };
        for (const std::uint32_t i : steps)
            if (!ends.contains(cut_.steps[i].from)) follow(cut_.steps[i].from);
        while (!by_start.empty()) follow(by_start.begin()->first); // loops
        return result;
    }

    /// The cosine of the angle by which the cut turns from one step to another.
    double straightness(std::uint32_t step, std::uint32_t next) const {
        const auto way = [&](std::uint32_t i) {
            return at(cut_.steps[i].to) - at(cut_.steps[i].from);
        };
        const double lengths = glm::length(way(step)) * glm::length(way(next));
        return lengths > 0 ? glm::dot(way(step), way(next)) / lengths : -1;
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
            const bool is_straight =
                curve_of_step_[i] != none && curves_[curve_of_step_[i]].is_straight;
            Guide guide{.curve = is_straight ? none : curve_of_step_[i],
                        .from = at(step.from),
                        .way = at(step.to) - at(step.from)};
            for (const std::uint32_t position : {step.from, step.to}) {
                if (guide.curve != none) guide.parameters = parameters_at(step, position);
                Guides& guides = places[position];
                guides.reach = std::max(guides.reach, 0.25 * longest_side(step.triangle));
                if (guide.curve != none || is_straight || !is_of_curves(step))
                    guides.all.push_back(guide);
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
        const auto is_on_curve = [](const Guide& one) { return one.curve != none; };
        auto first = std::ranges::find_if(guides, [&](const Guide& one) {
            return is_on_curve(one) && (curves_[one.curve].ellipse || one.parameters);
        });
        if (first == guides.end()) first = std::ranges::find_if(guides, is_on_curve);
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
        if (ellipse && its) return crossing(*ellipse, *its, place);
        if (!curve.parameters || !other.parameters) return std::nullopt;
        const PlacedSurface &one = mesh_.surfaces.surfaces[curves_[curve.curve].surface],
                            &two = mesh_.surfaces.surfaces[curves_[other.curve].surface];
        return place_on_both(mesh_.surfaces.shapes[one.shape], one, *curve.parameters,
                             mesh_.surfaces.shapes[two.shape], two, *other.parameters,
                             plane_.origin, plane_.normal);
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
            const double turn = cross(by_a, by_b);
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

    /// Divides steps of curves that are known by their places alone where these turn by so much
    /// that no smooth curve can be told from the ends.
    void divide_steps() {
        // Where parts touch, both are divided alike, or neither is.
        std::set<std::uint64_t> kept; // by their ends
        for (std::size_t i = 0; i < cut_.steps.size(); ++i)
            if (curve_of_step_[i] == none || !curves_[curve_of_step_[i]].is_of_places())
                kept.insert(pair_key(cut_.steps[i].from, cut_.steps[i].to));
        std::map<std::uint64_t, std::vector<std::uint32_t>> places; // from the lower end on
        const std::size_t count = cut_.steps.size();
        for (std::size_t i = 0; i < count; ++i) {
            const CutStep step = cut_.steps[i];
            const std::uint64_t ends = pair_key(step.from, step.to);
            if (kept.contains(ends)) continue;
            const std::optional<Corners> corners = corners_of(step);
            if (!corners) continue;
            const auto [found, is_new] = places.try_emplace(ends);
            if (is_new)
                for (const glm::dvec3& place : places_within(step, *corners)) {
                    found->second.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
                    mesh_.positions.push_back(plane_.placed(place));
                }
            if (is_new && step.from > step.to) std::ranges::reverse(found->second);
            std::vector<std::uint32_t> between = found->second;
            if (step.from > step.to) std::ranges::reverse(between);
            if (!between.empty()) divide(i, *corners, between);
        }
    }

    /// The corners of the triangle that has a step as its side.
    struct Corners {
        std::uint32_t triangle;
        std::uint32_t from, to; ///< numbers of corners, 0 to 2
    };

    std::optional<Corners> corners_of(const CutStep& step) const {
        const std::size_t end = std::min<std::size_t>(step.triangle + 2, mesh_.triangles.size());
        for (std::uint32_t i = step.triangle; i < end; ++i)
            for (std::uint32_t k = 0; k < 3; ++k) {
                const glm::uvec3 t = mesh_.triangles[i];
                const std::uint32_t next = (k + 1) % 3;
                if (t[static_cast<int>(k)] == step.to && t[static_cast<int>(next)] == step.from &&
                    mesh_.surfaces.of_triangle[i] == surface_of(step))
                    return Corners{i, next, k};
            }
        return std::nullopt;
    }

    /// Places of the curve within a step, from its start on; none if it hardly turns.
    std::vector<glm::dvec3> places_within(const CutStep& step, const Corners& corners) const {
        constexpr double most_turn = 10 * std::numbers::pi / 180;
        constexpr double most_parts = 16;
        const PlacedSurface& placed = mesh_.surfaces.surfaces[surface_of(step)];
        const std::array<glm::dvec2, 3>& parameters = mesh_.surfaces.parameters[corners.triangle];
        const glm::dvec3 from = at(step.from), to = at(step.to);
        const auto within = [&](double share) {
            return place_on_plane(
                mesh_.surfaces.shapes[placed.shape], placed, plane_.origin, plane_.normal,
                glm::mix(parameters[corners.from], parameters[corners.to], share));
        };
        const auto is_between = [&](glm::dvec3 a, glm::dvec3 place, glm::dvec3 b) {
            return glm::dot(place - a, b - a) > 0 && glm::dot(b - place, b - a) > 0;
        };
        const std::optional<glm::dvec3> middle = within(0.5);
        if (!middle || !is_between(from, *middle, to)) return {};
        const glm::dvec3 in = *middle - from, out = to - *middle;
        const double turn = 2 * std::atan2(glm::length(glm::cross(in, out)), glm::dot(in, out));
        const auto parts = static_cast<int>(std::min(std::ceil(turn / most_turn), most_parts));
        std::vector<glm::dvec3> places;
        glm::dvec3 before = from;
        for (int i = 1; i < parts; ++i) {
            const std::optional<glm::dvec3> place = within(static_cast<double>(i) / parts);
            if (!place || !is_between(before, *place, to)) return {};
            places.push_back(before = *place);
        }
        return places;
    }

    /// Divides a step, and with it its triangle, at positions from its start on.
    void divide(std::size_t number, const Corners& corners,
                const std::vector<std::uint32_t>& between) {
        const std::uint32_t whole = corners.triangle;
        const glm::uvec3 triangle = mesh_.triangles[whole];
        const std::array<glm::dvec2, 3> parameters = mesh_.surfaces.parameters[whole];
        std::array<glm::vec3, 3> normals{};
        if (!mesh_.corner_normals.empty())
            for (std::size_t k = 0; k < 3; ++k) normals[k] = mesh_.corner_normals[3 * whole + k];
        const CutStep step = cut_.steps[number];
        const std::size_t count = between.size() + 1;
        for (std::size_t i = 0; i < count; ++i) {
            CutStep part = step;
            if (i > 0) part.from = between[i - 1];
            if (i + 1 < count) part.to = between[i];
            part.triangle = i == 0 ? whole : add_copy(whole);
            const double start = static_cast<double>(i) / static_cast<double>(count),
                         end = static_cast<double>(i + 1) / static_cast<double>(count);
            glm::uvec3& positions = mesh_.triangles[part.triangle];
            positions = triangle;
            positions[static_cast<int>(corners.from)] = part.from;
            positions[static_cast<int>(corners.to)] = part.to;
            for (const auto& [corner, share] :
                 {std::pair{corners.from, start}, std::pair{corners.to, end}}) {
                mesh_.surfaces.parameters[part.triangle][corner] =
                    glm::mix(parameters[corners.from], parameters[corners.to], share);
                if (mesh_.corner_normals.empty()) continue;
                const glm::vec3 a = normals[corners.from], b = normals[corners.to];
                const glm::vec3 normal = glm::mix(a, b, static_cast<float>(share));
                const bool is_known = a != glm::vec3{0} && b != glm::vec3{0};
                mesh_.corner_normals[3 * std::size_t{part.triangle} + corner] =
                    is_known && glm::length(normal) > 0 ? glm::normalize(normal) : glm::vec3{0};
            }
            if (i == 0) {
                cut_.steps[number] = part;
            } else {
                cut_.steps.push_back(part);
                curve_of_step_.push_back(curve_of_step_[number]);
            }
        }
    }

    /// Adds a triangle like another, whose number is returned.
    std::uint32_t add_copy(std::uint32_t triangle) {
        const auto again = [&](auto& list) {
            if (list.empty()) return;
            const auto one = list[triangle];
            list.push_back(one);
        };
        const auto number = static_cast<std::uint32_t>(mesh_.triangles.size());
        if (!mesh_.corner_normals.empty()) mesh_.corner_normals.resize(3 * std::size_t{number} + 3);
        again(mesh_.triangles);
        again(mesh_.surfaces.of_triangle);
        again(mesh_.surfaces.parameters);
        again(mesh_.triangle_group);
        again(mesh_.triangle_object);
        again(cut_.parts.of_triangle);
        // The corner opposite the step keeps its normal.
        for (std::size_t k = 0; k < 3 && !mesh_.corner_normals.empty(); ++k)
            mesh_.corner_normals[3 * std::size_t{number} + k] =
                mesh_.corner_normals[3 * std::size_t{triangle} + k];
        return number;
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
