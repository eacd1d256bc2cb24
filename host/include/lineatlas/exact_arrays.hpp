#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// As MeshArrays, with coordinates that floats may not hold, such as those of surveys: farther from
/// zero than a thousand times the model's size.
struct ExactArrays {
    std::span<const double> positions;          ///< x, y, z of each vertex
    std::size_t stride = 3;                     ///< doubles, not bytes, to the next vertex
    std::span<const std::uint32_t> indices{};   ///< as MeshArrays::indices
    std::span<const std::uint32_t> materials{}; ///< as MeshArrays::materials
};

/// A mesh of exact arrays.
struct ExactMesh {
    Mesh mesh; ///< about `origin`
    /// What was taken off every position, as LoadedMesh::origin: zero, unless the model lies so far
    /// from zero, compared with its size, that floats there could not hold it. All places that go
    /// with the mesh are about it: cameras, matrices and positions that are set, intervals and
    /// picks that come back. Take it off your own in doubles.
    glm::dvec3 origin{0};
};

/// As make_mesh() of MeshArrays. A position that is no finite float once the origin is taken off
/// is refused by extract_lines(), as in any mesh.
LINEATLAS_API ExactMesh make_mesh(const ExactArrays& arrays);

} // namespace lineatlas
