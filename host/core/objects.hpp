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
    std::vector<std::string> names;       ///< per object; none: all of the mesh is one
    std::vector<std::uint32_t> triangles; ///< per triangle its object; empty: all 0
    std::vector<std::uint32_t> polylines; ///< likewise

    std::uint32_t of_triangle(std::size_t i) const { return triangles.empty() ? 0 : triangles[i]; }
    std::uint32_t of_polyline(std::size_t i) const { return polylines.empty() ? 0 : polylines[i]; }
};

/// See LineOptions::separate_objects. Throws UsageError where Mesh::triangle_object, or
/// Mesh::triangle_group in its place, doesn't fit.
MeshObjects find_objects(const Mesh& mesh);

/// The box around a moved box.
Bounds moved(const Bounds& box, const glm::mat4& world_from_object);

/// What turns normals as an object is moved: the inverse of the matrix, transposed, but for its
/// size. A mirror image keeps its outside; of what is not turned, it is exactly the identity.
/// Zero for a matrix that takes all to one point.
glm::mat3 normal_turn(const glm::mat4& world_from_object);

/// Throws UsageError unless there is a matrix for each of `count` objects, and all are affine and
/// can be inverted.
void check_transforms(std::span<const glm::mat4> world_from_object, std::size_t count);

/// Throws UsageError if one of what is to be hidden is none of `count` objects.
void check_objects(std::span<const std::uint32_t> hidden, std::size_t count);

} // namespace lineatlas
