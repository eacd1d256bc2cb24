#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/mesh.hpp"

/// @file
/// Meshes of a program's own doubles, which may lie far from zero.
/// @code{.cpp}
/// const std::vector<double> survey{500000.25, 0, 0, 500001.25, 0, 0, 500000.25, 1, 0};
/// const ExactMesh placed = make_mesh(ExactArrays{.positions = survey});
/// const LineSet lines_there = extract_lines(placed.mesh); // relative to placed.origin
/// @endcode

namespace lineatlas {

/// As MeshArrays, for coordinates that need more digits than floats have, such as those of surveys,
/// which lie farther from zero than thirty times the model's size.
struct ExactArrays {
    std::span<const double> positions;          ///< x, y, z of each vertex
    std::size_t stride = 3;                     ///< doubles, not bytes, to the next vertex
    std::span<const std::uint32_t> indices{};   ///< as MeshArrays::indices
    std::span<const std::uint32_t> materials{}; ///< as MeshArrays::materials
};

/// A mesh of exact arrays.
struct ExactMesh {
    Mesh mesh; ///< relative to `origin`
    /// The origin that was subtracted from every position, as LoadedMesh::origin. Zero, unless the
    /// model lies so far from zero, compared with its size, that floats could not hold its details.
    /// All coordinates that go with the mesh are relative to the origin: those of cameras, matrices
    /// and positions that are set, and those of intervals and picks that are returned. Subtract it
    /// from your own coordinates in doubles.
    glm::dvec3 origin{0};
};

/// As make_mesh() of MeshArrays. extract_lines() refuses a position that is no finite float after
/// the origin was subtracted, as in any mesh.
LINEATLAS_API ExactMesh make_mesh(const ExactArrays& arrays);

} // namespace lineatlas
