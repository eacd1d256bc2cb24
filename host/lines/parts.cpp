#include "parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ranges>
#include <span>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

#include "base/vertex_sets.hpp"

namespace lineatlas {

namespace {

/// What is known of the winding of a part by its edges.
struct PartEdges {
    bool has_border = false;
    bool is_mixed = false;   ///< two triangles run along an edge in one direction
    bool is_crowded = false; ///< more than two triangles meet at an edge
};

std::vector<PartEdges> edges_of_parts(const std::vector<MeshEdge>& edges, const MeshParts& parts) {
    std::vector<PartEdges> result(parts.count);
    for (const MeshEdge& edge : edges) {
        PartEdges& part = result[parts.of_vertex[edge.p]];
        part.has_border |= edge.face_count == 1;
        part.is_crowded |= edge.face_count > 2;
        part.is_mixed |= edge.face_count == 2 && (edge.face_b & LA_FACE_FLIPPED) != 0;
    }
    return result;
}

/// A place where a line along x goes through a triangle.
struct Crossing {
    double x = std::numeric_limits<double>::infinity();
    bool looks_along = false; ///< the triangle, towards larger x
};

/// Finds from which side triangles are seen that only lines along x tell apart.
class LinesAlongX {
  public:
    LinesAlongX(const WeldedMesh& mesh, std::span<const std::uint32_t> triangles)
        : mesh_(mesh), triangles_(triangles) {}

    /// The first of all crossings of a line through one of the triangles: what is seen of the part
    /// from outside. Nothing where the lines that were tried meet edges.
    std::optional<Crossing> outermost() const {
        constexpr std::size_t most_tries = 16;
        const std::size_t step = std::max<std::size_t>(triangles_.size() / most_tries, 1);
        for (std::size_t i = 0; i < triangles_.size(); i += step) {
            const std::optional<Crossing> found = first_on_line_through(inner_point(triangles_[i]));
            if (found && std::isfinite(found->x)) return found;
        }
        return {};
    }

  private:
    glm::dvec3 corner(std::uint32_t triangle, int k) const {
        return mesh_.vertices[mesh_.triangles[triangle][k]];
    }

    /// Not the middle: lines from there meet edges of regular meshes.
    glm::dvec3 inner_point(std::uint32_t triangle) const {
        return 0.41 * corner(triangle, 0) + 0.33 * corner(triangle, 1) + 0.26 * corner(triangle, 2);
    }

    std::optional<Crossing> first_on_line_through(glm::dvec3 point) const {
        Crossing first;
        for (const std::uint32_t triangle : triangles_) {
            const std::optional<Crossing> here = crossing(triangle, point);
            if (!here) return {};
            if (here->x < first.x) first = *here;
        }
        return first;
    }

    /// At infinity where there is none; nothing where the line meets an edge.
    std::optional<Crossing> crossing(std::uint32_t triangle, glm::dvec3 point) const {
        glm::dvec3 weights{0}; // twice the areas on the plane of y and z
        bool is_left = false, is_right = false, meets_edge = false;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 a = corner(triangle, (k + 1) % 3) - point;
            const glm::dvec3 b = corner(triangle, (k + 2) % 3) - point;
            const double one = a.y * b.z, other = a.z * b.y;
            const double rounding = 1e-12 * (std::abs(one) + std::abs(other));
            weights[k] = one - other;
            is_left |= weights[k] > rounding;
            is_right |= weights[k] < -rounding;
            meets_edge |= std::abs(weights[k]) <= rounding;
        }
        if (is_left && is_right) return Crossing{};
        if (meets_edge) return {};
        double x = 0;
        for (int k = 0; k < 3; ++k) x += weights[k] * corner(triangle, k).x;
        return Crossing{x / (weights.x + weights.y + weights.z), is_left};
    }

    const WeldedMesh& mesh_;
    std::span<const std::uint32_t> triangles_;
};

/// Which parts look inwards, of those where bodies abut: the faces between the bodies make their
/// volume unknown.
std::vector<bool> abutting_that_look_inwards(const WeldedMesh& mesh,
                                             const std::vector<MeshEdge>& edges,
                                             const MeshParts& parts) {
    std::vector<bool> inwards(parts.count, false);
    const std::vector<PartEdges> of_part = edges_of_parts(edges, parts);
    const auto is_asked = [&](std::uint32_t part) {
        return of_part[part].is_crowded && !of_part[part].has_border && !of_part[part].is_mixed;
    };
    const auto numbers = std::views::iota(0U, parts.count);
    if (std::ranges::none_of(numbers, is_asked)) return inwards;
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> triangles;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::uint32_t part = parts.of_vertex[mesh.triangles[i].x];
        if (is_asked(part)) triangles[part].push_back(i);
    }
    for (const auto& [part, own] : triangles) {
        const std::optional<Crossing> seen = LinesAlongX{mesh, own}.outermost();
        inwards[part] = seen && seen->looks_along;
    }
    return inwards;
}

} // namespace

MeshParts find_parts(const WeldedMesh& mesh) {
    VertexSets sets = joined_by(mesh.triangles, mesh.vertices.size());
    constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
    MeshParts parts{.of_vertex = std::vector<std::uint32_t>(mesh.vertices.size(), unknown)};
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        std::uint32_t& of_set = parts.of_vertex[sets.find(v)];
        if (of_set == unknown) of_set = parts.count++;
        parts.of_vertex[v] = of_set;
    }
    return parts;
}

std::vector<double> enclosed_volumes(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                                     const MeshParts& parts) {
    std::vector<double> volume(parts.count, 0);
    std::vector<glm::dvec3> origin(
        parts.count); // an origin per part, because a part may be far from all others
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
        origin[parts.of_vertex[v]] = mesh.vertices[v];
    for (const glm::uvec3& t : mesh.triangles) {
        const std::uint32_t part = parts.of_vertex[t.x];
        const auto from_origin = [&](std::uint32_t v) {
            return glm::dvec3{mesh.vertices[v]} - origin[part];
        };
        const glm::dvec3 a = from_origin(t.x), b = from_origin(t.y), c = from_origin(t.z);
        volume[part] += glm::dot(a, glm::cross(b, c));
    }
    for (const MeshEdge& edge : edges) {
        const bool flipped = (edge.face_b & LA_FACE_FLIPPED) != 0;
        if (edge.face_count != 2 || flipped) volume[parts.of_vertex[edge.p]] = 0;
    }
    return volume;
}

std::vector<bool> solid_parts(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                              const MeshParts& parts) {
    std::vector<bool> solid;
    for (const double volume : enclosed_volumes(mesh, edges, parts)) solid.push_back(volume > 0);
    return solid;
}

void turn_outwards(WeldedMesh& mesh, std::vector<MeshEdge>& edges, const MeshParts& parts) {
    std::vector<bool> inwards = abutting_that_look_inwards(mesh, edges, parts);
    const std::vector<double> volume = enclosed_volumes(mesh, edges, parts);
    for (std::uint32_t part = 0; part < parts.count; ++part)
        if (volume[part] < 0) inwards[part] = true;
    if (std::ranges::find(inwards, true) == inwards.end()) return;
    mesh.turned.assign(mesh.triangles.size(), false);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        glm::uvec3& t = mesh.triangles[i];
        mesh.turned[i] = inwards[parts.of_vertex[t.x]];
        if (mesh.turned[i]) std::swap(t.y, t.z);
    }
    for (MeshEdge& edge : edges)
        if (inwards[parts.of_vertex[edge.p]]) std::swap(edge.p, edge.q);
}

} // namespace lineatlas
