#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// Which object each part of a mesh belongs to.
struct MeshObjects {
    std::vector<std::string> names;       ///< per object; empty: the whole mesh is one object
    std::vector<std::uint32_t> triangles; ///< per triangle its object; empty: all 0
    std::vector<std::uint32_t> polylines; ///< likewise

    std::uint32_t of_triangle(std::size_t i) const { return triangles.empty() ? 0 : triangles[i]; }
    std::uint32_t of_polyline(std::size_t i) const { return polylines.empty() ? 0 : polylines[i]; }
};

/// See LineOptions::separate_objects. Throws UsageError if Mesh::triangle_object, or
/// Mesh::triangle_group in its place, does not fit the mesh.
MeshObjects find_objects(const Mesh& mesh);

/// The box around a moved box.
Bounds moved(const Bounds& box, const glm::mat4& world_from_object);

/// The matrix that turns normals when `world_from_object` moves an object: the transposed inverse
/// without its scale. A mirror image keeps its outside. The result is exactly the identity for an
/// object that is not turned, and zero for a matrix that moves all points to one.
glm::mat3 normal_turn(const glm::mat4& world_from_object);

/// Throws UsageError unless there is a matrix for each of `count` objects, and all are affine and
/// can be inverted.
void check_transforms(std::span<const glm::mat4> world_from_object, std::size_t count);

/// Throws UsageError if a number in `hidden` is not that of one of `count` objects.
void check_objects(std::span<const std::uint32_t> hidden, std::size_t count);

} // namespace lineatlas
