#pragma once

#include <cstdint>
#include <vector>

#include "weld.hpp"

namespace lineatlas {

/// What hangs together: triangles that share vertices.
struct MeshParts {
    std::vector<std::uint32_t> of_vertex; ///< numbered from 0 as they come
    std::uint32_t count = 0;
};

MeshParts find_parts(const WeldedMesh& mesh);

} // namespace lineatlas
