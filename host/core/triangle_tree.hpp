#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/common.hpp>

#include "box_tree.hpp"
#include "normal_cone.hpp"
#include "weld.hpp"

namespace lineatlas {

inline Bounds bounds_of(const WeldedMesh& mesh, std::uint32_t triangle) {
    const glm::uvec3 t = mesh.triangles[triangle];
    const glm::vec3 a = mesh.vertices[t.x], b = mesh.vertices[t.y], c = mesh.vertices[t.z];
    return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

/// Triangles of one object in a tree of the boxes around them, with cones of their normals. Its
/// owners are parts, which hang together by vertices.
class TriangleTree {
  public:
    TriangleTree(const WeldedMesh& mesh, std::span<const glm::dvec3> normals,
                 std::span<const std::uint32_t> part_of_vertex,
                 std::span<const std::uint32_t> triangles);

    /// Calls visit(t) for the triangles whose box meets `box`, but for those of one part. Some of
    /// those that lie at more than `angle` to all of `directions` are left out.
    template <class Visit>
    void visit_along(const Bounds& box, std::span<const glm::dvec3> directions, double angle,
                     std::uint32_t but, Visit&& visit) const {
        boxes_.visit_meeting(box, visit, but, [&](std::uint32_t node) {
            return std::ranges::any_of(directions, [&](const glm::dvec3& direction) {
                return cones_[node].may_be_along(direction, angle);
            });
        });
    }

    /// Calls visit(a, b), a < b, for every two triangles of different parts whose boxes meet. Some
    /// of those that lie at less than `angle` to each other are left out: of n sheets in one place
    /// nearly all of n^2 pairs.
    template <class Visit>
    void visit_pairs_at(double angle, Visit&& visit) const {
        boxes_.visit_meeting_pairs(visit, [&](std::uint32_t a, std::uint32_t b) {
            return NormalCone::may_differ(cones_[a], cones_[b], angle);
        });
    }

  private:
    BoxTree boxes_;
    std::vector<NormalCone> cones_; ///< of its nodes
};

/// A tree for each object: what stands beside it is nothing to its lines, since either may move.
class TriangleTrees {
  public:
    /// `object_of_triangle` must outlive it; empty: all are of one. `left_out`, of triangles, may
    /// be empty.
    TriangleTrees(const WeldedMesh& mesh, std::span<const glm::dvec3> normals,
                  std::span<const std::uint32_t> part_of_vertex,
                  std::span<const std::uint32_t> object_of_triangle,
                  const std::vector<bool>& left_out = {});

    std::size_t size() const { return trees_.size(); }
    const TriangleTree& operator[](std::size_t object) const { return trees_[object]; }
    const TriangleTree& of_triangle(std::uint32_t triangle) const {
        return trees_[objects_.empty() ? 0 : objects_[triangle]];
    }

  private:
    std::span<const std::uint32_t> objects_; ///< of triangles
    std::vector<TriangleTree> trees_;
};

} // namespace lineatlas
