#include "parts.hpp"

#include <limits>

#include "vertex_sets.hpp"

namespace lineatlas {

MeshParts find_parts(const WeldedMesh& mesh) {
    VertexSets sets{mesh.vertices.size()};
    for (const glm::uvec3& t : mesh.triangles) {
        sets.unite(t.x, t.y);
        sets.unite(t.y, t.z);
    }
    constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
    MeshParts parts{.of_vertex = std::vector<std::uint32_t>(mesh.vertices.size(), unknown)};
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        std::uint32_t& of_set = parts.of_vertex[sets.find(v)];
        if (of_set == unknown) of_set = parts.count++;
        parts.of_vertex[v] = of_set;
    }
    return parts;
}

} // namespace lineatlas
