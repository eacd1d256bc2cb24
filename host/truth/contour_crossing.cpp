#include "contour_crossing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "surface_triangle.hpp"

namespace lineatlas {
namespace {

/// A surface whose cosine to the view is below this is seen edge on and counts as turned away.
constexpr double edge_on = 1e-7;
/// If the cosines of all three corners' normals are above this, their signs are those of the
/// surface.
constexpr double sure = 0.02;

/// A triangle of Contours as one view sees it.
class SeenTriangle {
  public:
    using Place = SurfaceTriangle::Place;

    SeenTriangle(const LineSet& lines, const PreciseCamera& projection, std::uint32_t face)
        : lines_(lines), projection_(projection), face_(face) {
        const Contours& contours = lines.contours;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t side = contours.faces[face][static_cast<int>(k)];
            const glm::uvec2 ends = contours.edges[side & ~LA_CONTOUR_TURNED];
            const ContourCorner& corner =
                contours.corners[(side & LA_CONTOUR_TURNED) != 0 ? ends.y : ends.x];
            corners_[k] = {glm::dvec3{lines.vertices[corner.vertex]},
                           {corner.normal[0], corner.normal[1], corner.normal[2]}};
        }
    }

    /// Takes places from the surface from here on, if it is known.
    void ask_surface() {
        const KnownSurfaces& known = lines_.contours.surfaces;
        if (known.empty() || known.of_triangle[face_] == KnownSurfaces::none) return;
        surface_.emplace(known, face_, std::array{corners_[0].at, corners_[1].at, corners_[2].at});
    }

    bool has_surface() const { return surface_.has_value(); }

    const Place& corner(std::size_t k) const { return corners_[k]; }
    bool is_tip(std::size_t k) const { return corners_[k].normal == glm::dvec3{0}; }

    Place place(std::size_t a, std::size_t b, double share) const {
        Place flat{glm::mix(corners_[a].at, corners_[b].at, share),
                   glm::mix(corners_[a].normal, corners_[b].normal, share)};
        if (!surface_) return flat;
        glm::dvec3 shares{0};
        shares[static_cast<int>(a)] += 1 - share;
        shares[static_cast<int>(b)] += share;
        const Place place = surface_->place(shares);
        // A pole has a normal too, although its parameters do not give it.
        return place.normal != glm::dvec3{0} ? place : Place{place.at, flat.normal};
    }

    double facing(const Place& place) const {
        const glm::dvec3 to_eye = projection_.start_of_sight(place.at) - place.at;
        return glm::dot(place.normal, to_eye) / glm::length(to_eye) - edge_on;
    }

    bool is_surely_turned_one_way() const {
        int fronts = 0;
        for (const Place& corner : corners_) {
            const double cosine = facing(corner);
            if (std::abs(cosine) < sure) return false;
            fronts += cosine > 0 ? 1 : 0;
        }
        return fronts == 0 || fronts == 3;
    }

    Place between(std::size_t a, std::size_t b, bool front_at_a) const {
        double low = 0, high = 1;
        for (int i = 0; i < 48; ++i) {
            const double middle = 0.5 * (low + high);
            ((facing(place(a, b, middle)) >= 0) == front_at_a ? low : high) = middle;
        }
        return place(a, b, 0.5 * (low + high));
    }

    glm::dvec3 way_to_eye(const glm::dvec3& at) const {
        return projection_.start_of_sight(at) - at;
    }

  private:
    const LineSet& lines_;
    const PreciseCamera& projection_;
    std::uint32_t face_;
    std::array<Place, 3> corners_{};
    std::optional<SurfaceTriangle> surface_;
};

} // namespace

std::optional<ContourCrossing>
contour_crossing(const LineSet& lines, const PreciseCamera& projection, std::uint32_t face) {
    SeenTriangle triangle{lines, projection, face};
    std::size_t tip = 3;
    for (std::size_t k = 0; k < 3; ++k)
        if (triangle.is_tip(k)) tip = k;
    if (tip == 3 && triangle.is_surely_turned_one_way()) return {};
    triangle.ask_surface();
    std::array<double, 3> facing{};
    for (std::size_t k = 0; k < 3; ++k)
        if (k != tip) facing[k] = triangle.facing(triangle.place(k, k, 0));
    if (tip < 3)
        facing[tip] = facing[(tip + 1) % 3]; // a silhouette across the opposite side runs
                                             // into the tip
    std::array<SeenTriangle::Place, 2> ends{};
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (k == tip || next == tip || (facing[k] >= 0) == (facing[next] >= 0)) continue;
        ends[found++] = triangle.between(k, next, facing[k] >= 0);
    }
    if (found == 0) return {};
    if (found == 1) ends[1] = {triangle.corner(tip).at, ends[0].normal};
    if (ends[0].at == ends[1].at) return {};
    // The front grows towards the eye where the surface bends away from it.
    const glm::dvec3 middle = 0.5 * (ends[0].at + ends[1].at);
    const glm::dvec3 along = glm::normalize(ends[1].at - ends[0].at);
    const glm::dvec3 to_eye = triangle.way_to_eye(middle);
    double most = 0;
    bool shows_front = true;
    for (std::size_t k = 0; k < 3; ++k) {
        if (k == tip || std::abs(facing[k]) <= most) continue;
        most = std::abs(facing[k]);
        const glm::dvec3 way = triangle.corner(k).at - middle;
        const glm::dvec3 aside = way - glm::dot(way, along) * along;
        shows_front = (glm::dot(aside, to_eye) > 0) == (facing[k] >= 0);
    }
    const glm::dvec3 normal = glm::normalize(ends[0].normal + ends[1].normal);
    return ContourCrossing{.from = ends[0].at,
                           .to = ends[1].at,
                           .on_known_surface = triangle.has_surface(),
                           .shows_front = shows_front,
                           .beyond = shows_front ? normal : -normal};
}

} // namespace lineatlas
