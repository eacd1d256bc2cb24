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
/// owners are parts, whose triangles are connected by vertices.
class TriangleTree {
  public:
    TriangleTree(const WeldedMesh& mesh, std::span<const glm::dvec3> normals,
                 std::span<const std::uint32_t> part_of_vertex,
                 std::span<const std::uint32_t> triangles);

    /// Calls visit(t) for the triangles whose box meets `box`, except those of one part. May leave
    /// out triangles that lie at more than `angle` to all of `directions`.
    template <class Visit>
    void visit_along(const Bounds& box, std::span<const glm::dvec3> directions, double angle,
                     std::uint32_t but, Visit&& visit) const {
        boxes_.visit_meeting(box, visit, but, [&](std::uint32_t node) {
            return std::ranges::any_of(directions, [&](const glm::dvec3& direction) {
                return cones_[node].may_be_along(direction, angle);
            });
        });
    }

    /// Calls visitors[i](a, b) for every two triangles a < b of different parts whose boxes meet.
    /// make() makes a visitor for each part of the work, which several threads do at once. Returns
    /// the visitors: together, in their order, they have met the pairs that a single visitor would
    /// have met. May leave out pairs that lie at less than `angle` to each other; of n sheets in
    /// one place these are nearly all of n^2 pairs.
    template <class Visitor, class Make>
    std::vector<Visitor> visit_pairs_at(double angle, const Make& make) const {
        const auto may = [&](std::uint32_t a, std::uint32_t b) {
            return NormalCone::may_differ(cones_[a], cones_[b], angle);
        };
        const std::vector<BoxTree::NodePair> parts = boxes_.parts_of_pairs(may);
        std::vector<Visitor> visitors;
        for (std::size_t i = 0; i < parts.size(); ++i) visitors.push_back(make());
        for_each_index(
            parts.size(),
            [&](std::size_t i) { boxes_.visit_meeting_pairs(parts[i], visitors[i], may); }, 1);
        return visitors;
    }

  private:
    BoxTree boxes_;
    std::vector<NormalCone> cones_; ///< cones of the tree's nodes
};

/// A tree for each object. Other objects do not affect its lines, because either may move.
class TriangleTrees {
  public:
    /// `object_of_triangle` must outlive this object; empty: all triangles are of one. `left_out`:
    /// per triangle; may be empty.
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
