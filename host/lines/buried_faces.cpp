#include "buried_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "box_tree.hpp"
#include "core/contact.hpp"
#include "triangle_tree.hpp"

namespace lineatlas {
namespace {

/// The number of parts that must surround a triangle. An eye that stands within one of them, as in
/// a room, still does not see the triangle.
constexpr int needed = 2;

bool lies_within(const Bounds& inner, const Bounds& outer) {
    return glm::min(inner.min, outer.min) == outer.min &&
           glm::max(inner.max, outer.max) == outer.max;
}

class BuriedFaces {
  public:
    BuriedFaces(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                const std::vector<glm::dvec3>& normals, const MeshParts& parts, double diagonal,
                const std::vector<bool>& left_out)
        : mesh_(mesh), normals_(normals), parts_(parts), left_out_(left_out),
          contact_(contact_of(diagonal, mesh.precision)), boxes_(parts.count),
          is_buried_(mesh.triangles.size(), false) {
        sort_triangles();
        find_closed(edges);
    }

    std::vector<bool> run() {
        std::uint32_t vertex = 0, first = 0;
        for (const std::uint32_t vertex_end : mesh_.object_ends) {
            // Vertices come by object, and parts by their first vertex.
            std::uint32_t end = first;
            for (; vertex < vertex_end; ++vertex) end = std::max(end, parts_.of_vertex[vertex] + 1);
            look_at_object(first, end);
            first = end;
        }
        return std::move(is_buried_);
    }

  private:
    std::span<const std::uint32_t> triangles_of(std::uint32_t part) const {
        return std::span{triangles_}.subspan(first_[part], first_[part + 1] - first_[part]);
    }

    std::uint32_t part_of(std::uint32_t triangle) const {
        return parts_.of_vertex[mesh_.triangles[triangle].x];
    }

    void sort_triangles() {
        const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
        first_.assign(parts_.count + 1, 0);
        for (std::uint32_t t = 0; t < count; ++t) {
            ++first_[part_of(t) + 1];
            Bounds& box = boxes_[part_of(t)];
            const Bounds own = bounds_of(mesh_, t);
            box = {glm::min(box.min, own.min), glm::max(box.max, own.max)};
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        triangles_.resize(count);
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t t = 0; t < count; ++t) triangles_[next[part_of(t)]++] = t;
    }

    void find_closed(const std::vector<MeshEdge>& edges) {
        const std::vector<double> volume = enclosed_volumes(mesh_, edges, parts_);
        std::vector<std::size_t> edge_count(parts_.count, 0);
        for (const MeshEdge& edge : edges) ++edge_count[parts_.of_vertex[edge.p]];
        for (std::uint32_t part = 0; part < parts_.count; ++part) {
            const std::span<const std::uint32_t> triangles = triangles_of(part);
            // Faces that lie on each other count as one at an edge, but not for a ray.
            const bool is_closed =
                volume[part] != 0 && 3 * triangles.size() == 2 * edge_count[part];
            const bool was_turned =
                is_closed && !mesh_.turned.empty() && mesh_.turned[triangles.front()];
            is_closed_.push_back(is_closed);
            looks_inwards_.push_back(is_closed && (was_turned || volume[part] < 0));
        }
    }

    void look_at_object(std::uint32_t first, std::uint32_t end) {
        const BoxTree closed =
            tree_of_parts(first, end, [&](std::uint32_t part) { return is_closed_[part]; });
        const BoxTree cavities = tree_of_parts(first, end, [&](std::uint32_t part) {
            return looks_inwards_[part] &&
                   closed.any_meeting(boxes_[part], [&](std::uint32_t other) {
                       return !looks_inwards_[other] && lies_within(boxes_[part], boxes_[other]);
                   });
        });
        for (std::uint32_t part = first; part < end; ++part) {
            if (is_left_out(part) || !reaches_into_enough(part, closed)) continue;
            for (const std::uint32_t t : triangles_of(part))
                is_buried_[t] = is_buried(t, part, closed, cavities);
        }
    }

    bool is_left_out(std::uint32_t part) const {
        return !left_out_.empty() && !triangles_of(part).empty() &&
               left_out_[triangles_of(part).front()];
    }

    template <class Is>
    BoxTree tree_of_parts(std::uint32_t first, std::uint32_t end, const Is& is) const {
        std::vector<Bounds> boxes;
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t part = first; part < end; ++part) {
            if (!is(part)) continue;
            boxes.push_back(boxes_[part]);
            numbers.push_back(part);
        }
        return BoxTree{boxes, {}, numbers};
    }

    /// Whether a part reaches out of another one. It does if its box does.
    bool reaches_out(std::uint32_t part, std::uint32_t of) const {
        return part != of && !lies_within(boxes_[part], boxes_[of]);
    }

    bool reaches_into_enough(std::uint32_t part, const BoxTree& closed) const {
        int count = 0;
        return closed.any_meeting(boxes_[part], [&](std::uint32_t other) {
            return reaches_out(part, other) && ++count == needed;
        });
    }

    bool is_buried(std::uint32_t triangle, std::uint32_t part, const BoxTree& closed,
                   const BoxTree& cavities) {
        const Bounds box = bounds_of(mesh_, triangle);
        int count = 0;
        const bool is_within_enough = closed.any_meeting(box, [&](std::uint32_t other) {
            return reaches_out(part, other) && lies_within(box, boxes_[other]) &&
                   holds(other, triangle, box) && ++count == needed;
        });
        return is_within_enough && !cavities.any_meeting(box, [](std::uint32_t) { return true; });
    }

    const BoxTree& tree_of(std::uint32_t part) {
        const auto known = trees_.find(part);
        if (known != trees_.end()) return known->second;
        std::vector<Bounds> boxes;
        for (const std::uint32_t t : triangles_of(part)) boxes.push_back(bounds_of(mesh_, t));
        return trees_.try_emplace(part, boxes, std::span<const std::uint32_t>{}, triangles_of(part))
            .first->second;
    }

    bool holds(std::uint32_t part, std::uint32_t triangle, const Bounds& box) {
        const BoxTree& tree = tree_of(part);
        const auto reach = static_cast<float>(contact_);
        const bool meets =
            tree.any_meeting({box.min - reach, box.max + reach}, [&](std::uint32_t other) {
                return !is_beside(triangle, other) && !is_beside(other, triangle);
            });
        return !meets && is_inside(tree, inner_point(triangle));
    }

    glm::dvec3 at(std::uint32_t vertex) const { return mesh_.vertices[vertex]; }

    /// True if all of a triangle lies on one side of the plane of another.
    bool is_beside(std::uint32_t triangle, std::uint32_t plane) const {
        const glm::dvec3 origin = at(mesh_.triangles[plane].x);
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 corner = at(mesh_.triangles[triangle][k]);
            const double height = glm::dot(normals_[plane], corner - origin);
            least = std::min(least, height);
            most = std::max(most, height);
        }
        return least > contact_ || most < -contact_;
    }

    /// A point within a triangle. It is not the middle, because rays from there meet edges of
    /// regular meshes.
    glm::dvec3 inner_point(std::uint32_t triangle) const {
        const glm::uvec3 t = mesh_.triangles[triangle];
        return 0.41 * at(t.x) + 0.33 * at(t.y) + 0.26 * at(t.z);
    }

    enum class Hit { none, one, unsure };

    /// Whether a point is inside; false if the ray that decides meets an edge.
    bool is_inside(const BoxTree& tree, glm::dvec3 point) const {
        constexpr float infinite = std::numeric_limits<float>::infinity();
        const glm::vec3 rounded{point};
        const auto below = [](float x) { return std::nextafter(x, -infinite); };
        const auto above = [](float x) { return std::nextafter(x, infinite); };
        const Bounds ray{{below(rounded.x), below(rounded.y), below(rounded.z)},
                         {infinite, above(rounded.y), above(rounded.z)}};
        int hits = 0;
        const bool is_unsure = tree.any_meeting(ray, [&](std::uint32_t triangle) {
            const Hit hit = hit_along_x(triangle, point);
            hits += hit == Hit::one ? 1 : 0;
            return hit == Hit::unsure;
        });
        return !is_unsure && hits % 2 == 1;
    }

    Hit hit_along_x(std::uint32_t triangle, glm::dvec3 point) const {
        const glm::uvec3 t = mesh_.triangles[triangle];
        bool is_left = true, is_right = true, is_unsure = false;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 way = at(t[(k + 1) % 3]) - at(t[k]), to_point = point - at(t[k]);
            const double one = way.y * to_point.z, other = way.z * to_point.y;
            const double rounding = 1e-12 * (std::abs(one) + std::abs(other));
            is_left = is_left && one - other > -rounding;
            is_right = is_right && one - other < rounding;
            is_unsure = is_unsure || std::abs(one - other) <= rounding;
        }
        if (!is_left && !is_right) return Hit::none;
        if (is_unsure) return Hit::unsure;
        const glm::dvec3 normal = glm::cross(at(t.y) - at(t.x), at(t.z) - at(t.x));
        const double height = glm::dot(normal, point - at(t.x));
        return (height < 0) == (normal.x > 0) ? Hit::one : Hit::none;
    }

    const WeldedMesh& mesh_;
    const std::vector<glm::dvec3>& normals_;
    const MeshParts& parts_;
    const std::vector<bool>& left_out_;            ///< triangles; may be empty
    double contact_;                               ///< points no farther away than this touch
    std::vector<Bounds> boxes_;                    ///< of parts
    std::vector<std::uint32_t> first_, triangles_; ///< of parts: where theirs begin
    std::vector<bool> is_closed_, looks_inwards_;  ///< of parts; in the file
    std::unordered_map<std::uint32_t, BoxTree>
        trees_; ///< trees of the triangles of parts, made when they are asked for
    std::vector<bool> is_buried_;
};

} // namespace

std::vector<bool> buried_faces(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                               const std::vector<glm::dvec3>& normals, const MeshParts& parts,
                               double diagonal, const std::vector<bool>& left_out) {
    return BuriedFaces{mesh, edges, normals, parts, diagonal, left_out}.run();
}

} // namespace lineatlas
