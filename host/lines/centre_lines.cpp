#include "centre_lines.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "base/groups.hpp"
#include "diagonal.hpp"
#include "surface/round_surface.hpp"

namespace lineatlas {
namespace {

/// Axes are one axis if they are no farther apart than this share of the model's diagonal, and
/// their directions differ by no more than this sine.
constexpr double same_line = 1e-6, same_direction = 1e-6;
/// A surface that covers less than this is a fillet or a bend, and no hole or shaft. It is half a
/// turn, less the error of tessellation.
constexpr double least_turn = 170; // degrees
/// Surfaces of one axis that are farther apart than this many of their radii get an axis each.
constexpr double longest_gap = 4;
/// A face is square to an axis to this sine.
constexpr double square = 1e-3;

/// Degrees around an axis that surfaces cover.
using Turn = std::bitset<360>;

struct Extent {
    double from = std::numeric_limits<double>::infinity(), to = -from;
    void add(double at) {
        from = std::min(from, at);
        to = std::max(to, at);
    }
};

/// Two directions square to an axis. The first is the nearest to an axis of coordinates.
std::array<glm::dvec3, 2> across(glm::dvec3 axis) {
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(axis[i]) < std::abs(axis[least])) least = i;
    glm::dvec3 u{0};
    u[least] = 1;
    u = glm::normalize(u - glm::dot(u, axis) * axis);
    return {u, glm::cross(axis, u)};
}

/// A round surface, with its triangles.
struct Round {
    AxisLine axis; ///< its point is the nearest to the origin
    std::uint32_t object = 0;
    std::vector<std::uint32_t> triangles{}; ///< of the welded mesh
};

/// An axis with one of its two directions, the same for all equal axes.
AxisLine in_order(const AxisLine& axis) {
    glm::dvec3 along = axis.direction;
    for (int i = 0; i < 3; ++i) {
        if (std::abs(along[i]) <= same_direction) continue;
        if (along[i] < 0) along = -along;
        break;
    }
    return {axis.point - glm::dot(axis.point, along) * along, along};
}

bool is_same(const AxisLine& a, const AxisLine& b, double tolerance) {
    return glm::length(glm::cross(a.direction, b.direction)) <= same_direction &&
           glm::distance(a.point, b.point) <= tolerance;
}

/// Surfaces that share an axis and lie beside each other.
struct Body {
    AxisLine axis;
    Extent along{};
    double radius = 0; ///< the largest
    Turn turn{};
    std::uint32_t triangle = 0; ///< one triangle of them, in the welded mesh
    std::vector<std::uint32_t> triangles{};
};

class Centres {
  public:
    Centres(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
            const std::vector<glm::dvec3>& normals, const KnownSurfaces& surfaces,
            std::span<const SurfaceShape> shapes, std::span<const std::uint32_t> objects)
        : mesh_(mesh), edges_(edges), normals_(normals), surfaces_(surfaces), shapes_(shapes),
          objects_(objects), tolerance_(same_line * diagonal_of(mesh.vertices)) {}

    std::vector<CentreLine> find() {
        std::vector<Round> rounds = find_rounds();
        std::ranges::sort(rounds, [](const Round& a, const Round& b) {
            return std::tuple{a.object, a.axis.point.x, a.triangles.front()} <
                   std::tuple{b.object, b.axis.point.x, b.triangles.front()};
        });
        std::vector<bool> is_taken(rounds.size(), false);
        for (std::size_t i = 0; i < rounds.size(); ++i) {
            if (is_taken[i]) continue;
            std::vector<Body> bodies{body_of(rounds[i])};
            for (std::size_t k = i + 1; k < rounds.size() && may_share(rounds[i], rounds[k]); ++k) {
                if (is_taken[k] || !is_same(rounds[i].axis, rounds[k].axis, tolerance_)) continue;
                is_taken[k] = true;
                bodies.push_back(body_of(rounds[k], rounds[i].axis));
            }
            for (const Body& body : joined(std::move(bodies)))
                if (body.turn.count() >= static_cast<std::size_t>(least_turn)) add(body);
        }
        return std::move(lines_);
    }

  private:
    std::uint32_t object_of(std::uint32_t triangle) const {
        return objects_.empty() ? 0 : objects_[triangle];
    }

    glm::dvec3 corner(std::uint32_t triangle, int k) const {
        return mesh_.vertices[mesh_.triangles[triangle][k]];
    }

    bool may_share(const Round& a, const Round& b) const {
        return a.object == b.object && b.axis.point.x - a.axis.point.x <= tolerance_;
    }

    std::vector<Round> find_rounds() const {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
        std::vector<Round> rounds;
        for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
            const std::uint32_t surface = surfaces_.of_triangle[mesh_.triangle_source[i]];
            if (surface == KnownSurfaces::none) continue;
            const PlacedSurface& placed = surfaces_.surfaces[surface];
            const auto [entry, is_new] = known.try_emplace({object_of(i), surface}, not_round);
            if (is_new) {
                const auto axis = axis_of(shapes_[placed.shape], placed);
                if (!axis) continue;
                entry->second = static_cast<std::uint32_t>(rounds.size());
                rounds.push_back({.axis = in_order(*axis), .object = object_of(i)});
            }
            if (entry->second != not_round) rounds[entry->second].triangles.push_back(i);
        }
        return rounds;
    }

    Body body_of(const Round& round) const { return body_of(round, round.axis); }

    Body body_of(const Round& round, const AxisLine& axis) const {
        Body body{.axis = axis, .triangle = round.triangles.front(), .triangles = round.triangles};
        const auto [u, v] = across(axis.direction);
        for (const std::uint32_t triangle : round.triangles) {
            std::array<double, 3> angles{};
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3 at = corner(triangle, k) - axis.point;
                const double x = glm::dot(at, u), y = glm::dot(at, v);
                body.along.add(glm::dot(at, axis.direction));
                body.radius = std::max(body.radius, std::hypot(x, y));
                angles[static_cast<std::size_t>(k)] = std::atan2(y, x);
            }
            cover(body.turn, angles);
        }
        return body;
    }

    /// The degrees that a triangle covers, which are fewer than half a turn.
    static void cover(Turn& turn, const std::array<double, 3>& angles) {
        constexpr double whole = 2 * std::numbers::pi;
        double least = 0, most = 0; // from the first corner
        for (const double angle : angles) {
            const double way = std::remainder(angle - angles[0], whole);
            least = std::min(least, way);
            most = std::max(most, way);
        }
        const double degree = std::numbers::pi / 180;
        const auto first = static_cast<int>(std::floor((angles[0] + least) / degree));
        const auto last = static_cast<int>(std::ceil((angles[0] + most) / degree));
        for (int i = first; i < last; ++i)
            turn.set(static_cast<std::size_t>((i % 360 + 360) % 360));
    }

    static std::vector<Body> joined(std::vector<Body> bodies) {
        std::ranges::stable_sort(bodies, {}, [](const Body& body) { return body.along.from; });
        std::vector<Body> result;
        for (Body& next : bodies) {
            const bool is_near =
                !result.empty() && next.along.from - result.back().along.to <=
                                       longest_gap * std::max(next.radius, result.back().radius);
            if (!is_near) {
                result.push_back(std::move(next));
                continue;
            }
            Body& before = result.back();
            before.along.add(next.along.to);
            before.radius = std::max(before.radius, next.radius);
            before.turn |= next.turn;
            before.triangles.insert(before.triangles.end(), next.triangles.begin(),
                                    next.triangles.end());
        }
        return result;
    }

    glm::dvec3 on_axis(const Body& body, double along) const {
        return body.axis.point + along * body.axis.direction;
    }

    CentreLine line(const Body& body, glm::dvec3 p, glm::dvec3 q) const {
        return {.p = glm::vec3{p},
                .q = glm::vec3{q},
                .vertex = mesh_.triangles[body.triangle].x,
                .source = mesh_.triangle_source[body.triangle]};
    }

    void add(const Body& body) {
        lines_.push_back(line(body, on_axis(body, body.along.from), on_axis(body, body.along.to)));
        const std::optional<std::uint32_t> face = square_face(body);
        if (!face) return;
        for (const bool at_end : {false, true}) {
            const double end = at_end ? body.along.to : body.along.from;
            const double radius = radius_at(body, end);
            const bool looks_along = glm::dot(normals_[*face], body.axis.direction) > 0;
            for (const glm::dvec3 way : across(body.axis.direction)) {
                const glm::dvec3 middle = on_axis(body, end);
                CentreLine mark = line(body, middle - radius * way, middle + radius * way);
                mark.face = *face;
                mark.is_turned = looks_along != at_end;
                lines_.push_back(mark);
            }
        }
    }

    /// The radius of the circle at an end of the body, or of the whole body if it ends in a tip.
    double radius_at(const Body& body, double end) const {
        double radius = 0;
        const double near = tolerance_ + 1e-6 * (body.along.to - body.along.from);
        for (const std::uint32_t triangle : body.triangles) {
            for (int k = 0; k < 3; ++k) {
                const glm::dvec3 at = corner(triangle, k) - body.axis.point;
                const double along = glm::dot(at, body.axis.direction);
                if (std::abs(along - end) > near) continue;
                radius = std::max(radius, glm::length(at - along * body.axis.direction));
            }
        }
        return radius > near ? radius : body.radius;
    }

    void find_neighbours() {
        beside_.emplace(mesh_.triangles.size(), edges_.size(), [&](std::size_t i, const auto& add) {
            const MeshEdge& edge = edges_[i];
            if (edge.face_count != 2) return;
            const std::uint32_t a = edge.face_a, b = edge.face_b & LA_FACE_INDEX;
            add(a, b);
            add(b, a);
        });
    }

    /// The first triangle beside the body that lies square to the axis.
    std::optional<std::uint32_t> square_face(const Body& body) {
        if (!beside_) find_neighbours();
        std::optional<std::uint32_t> found;
        for (const std::uint32_t triangle : body.triangles) {
            for (const std::uint32_t face : (*beside_)[triangle]) {
                const glm::dvec3 normal = normals_[face];
                const double sine = glm::length(glm::cross(normal, body.axis.direction));
                if (normal != glm::dvec3{0} && sine <= square)
                    found = std::min(found.value_or(face), face);
            }
        }
        return found;
    }

    static constexpr std::uint32_t not_round = 0xFFFFFFFF;

    const WeldedMesh& mesh_;
    const std::vector<MeshEdge>& edges_;
    const std::vector<glm::dvec3>& normals_;
    const KnownSurfaces& surfaces_;
    std::span<const SurfaceShape> shapes_;
    std::span<const std::uint32_t> objects_;
    double tolerance_;
    std::optional<Groups<std::uint32_t>> beside_; ///< per triangle those that share an edge with it
    std::vector<CentreLine> lines_;
};

} // namespace

std::vector<CentreLine>
find_centre_lines(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                  const std::vector<glm::dvec3>& normals, const KnownSurfaces& surfaces,
                  std::span<const SurfaceShape> shapes, std::span<const std::uint32_t> objects) {
    if (surfaces.empty()) return {};
    return Centres{mesh, edges, normals, surfaces, shapes, objects}.find();
}

} // namespace lineatlas
