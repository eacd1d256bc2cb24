#include "undesigned_faces.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

constexpr double coplanar_bend = 3.5e-4;       ///< 0.02 degrees
constexpr double most_coplanar = 0.2;          ///< of the area of a part, and of the whole model
constexpr double least_altitude = 0.1;         ///< of the longest edge; slivers have less
constexpr double most_slivers = 0.1;           ///< of a part's area
constexpr std::uint32_t least_triangles = 500; ///< of a part

} // namespace

std::vector<std::uint32_t> undesigned_faces(const WeldedMesh& mesh,
                                            const std::vector<MeshEdge>& edges,
                                            std::span<const double> bends, const MeshParts& parts) {
    const std::vector<bool> coplanar =
        flat_faces(mesh.triangles.size(), edges, bends, coplanar_bend);
    struct Area {
        double all = 0, coplanar = 0, slivers = 0;
        std::uint32_t triangles = 0;
        bool is_designed() const {
            return triangles < least_triangles || coplanar > most_coplanar * all ||
                   slivers > most_slivers * all;
        }
    };
    std::vector<Area> of_part(parts.count);
    Area model;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const glm::uvec3 t = mesh.triangles[f];
        const glm::dvec3 a{mesh.vertices[t.x]}, b{mesh.vertices[t.y]}, c{mesh.vertices[t.z]};
        const double twice = glm::length(glm::cross(b - a, c - a));
        const double longest =
            std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
        for (Area* area : {&of_part[parts.of_vertex[t.x]], &model}) {
            ++area->triangles;
            area->all += twice;
            area->coplanar += coplanar[f] ? twice : 0;
            area->slivers += twice < least_altitude * longest ? twice : 0;
        }
    }
    std::vector<std::uint32_t> faces;
    if (model.is_designed()) return faces;
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
        if (!of_part[parts.of_vertex[mesh.triangles[f].x]].is_designed()) faces.push_back(f);
    return faces;
}

} // namespace lineatlas
