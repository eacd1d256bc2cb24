#include "triangle_tree.hpp"

namespace lineatlas {
namespace {

BoxTree boxes_of(const WeldedMesh& mesh, std::span<const std::uint32_t> part_of_vertex,
                 std::span<const std::uint32_t> triangles) {
    std::vector<Bounds> boxes(triangles.size());
    std::vector<std::uint32_t> owners(triangles.size());
    for_each_index(triangles.size(), [&](std::size_t i) {
        boxes[i] = bounds_of(mesh, triangles[i]);
        owners[i] = part_of_vertex[mesh.triangles[triangles[i]].x];
    });
    return BoxTree{boxes, owners, triangles};
}

} // namespace

TriangleTree::TriangleTree(const WeldedMesh& mesh, std::span<const glm::dvec3> normals,
                           std::span<const std::uint32_t> part_of_vertex,
                           std::span<const std::uint32_t> triangles)
    : boxes_(boxes_of(mesh, part_of_vertex, triangles)),
      cones_(boxes_.values_of_nodes<NormalCone>(
          [&](std::uint32_t t) { return NormalCone::of(normals[t]); }, NormalCone::around)) {}

TriangleTrees::TriangleTrees(const WeldedMesh& mesh, std::span<const glm::dvec3> normals,
                             std::span<const std::uint32_t> part_of_vertex,
                             std::span<const std::uint32_t> object_of_triangle,
                             const std::vector<bool>& left_out)
    : objects_(object_of_triangle) {
    std::vector<std::vector<std::uint32_t>> of_object(mesh.object_ends.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (left_out.empty() || !left_out[t])
            of_object[objects_.empty() ? 0 : objects_[t]].push_back(t);
    }
    trees_.reserve(of_object.size());
    for (const std::vector<std::uint32_t>& triangles : of_object)
        trees_.emplace_back(mesh, normals, part_of_vertex, triangles);
}

} // namespace lineatlas
