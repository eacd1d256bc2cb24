#include "triangle_groups.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace lineatlas {

void add_colors(const std::vector<MeshGroup>& groups,
                const std::vector<std::uint32_t>& triangle_group, LineSet& result) {
    std::map<std::array<float, 3>, std::uint16_t> known;
    const auto coded = [&](const MeshGroup& group) -> std::uint16_t {
        if (!group.color) return LineSet::no_color;
        const glm::vec3 color = *group.color;
        const auto found = known.find({color.x, color.y, color.z});
        if (found != known.end()) return found->second;
        if (known.size() == LineSet::no_color) return LineSet::no_color;
        const auto fresh = static_cast<std::uint16_t>(known.size());
        known[{color.x, color.y, color.z}] = fresh;
        result.colors.push_back(color);
        return fresh;
    };
    std::vector<std::uint16_t> color_of_group;
    color_of_group.reserve(groups.size());
    for (const MeshGroup& group : groups) color_of_group.push_back(coded(group));
    if (result.colors.empty()) return;
    result.triangle_color.reserve(triangle_group.size());
    for (const std::uint32_t group : triangle_group)
        result.triangle_color.push_back(color_of_group[group]);
}

std::vector<std::uint32_t> materials_of(const std::vector<MeshGroup>& groups,
                                        const WeldedMesh& mesh,
                                        const std::vector<std::uint32_t>& objects) {
    std::map<std::pair<std::string, bool>, std::uint32_t> known;
    std::vector<std::uint32_t> of_group;
    for (const MeshGroup& group : groups) {
        const bool named = !group.material.empty();
        const auto fresh = static_cast<std::uint32_t>(known.size());
        of_group.push_back(
            known.emplace(std::pair{named ? group.material : group.object, named}, fresh)
                .first->second);
    }
    std::vector<std::uint32_t> materials(mesh.triangles.size(), 0);
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (!of_group.empty()) materials[i] = of_group[mesh.triangle_group[i]];
        if (!objects.empty())
            materials[i] +=
                objects[i] * std::max<std::uint32_t>(1, static_cast<std::uint32_t>(known.size()));
    }
    return materials;
}

std::vector<std::uint32_t> bodies_of(const std::vector<MeshGroup>& groups, const WeldedMesh& mesh,
                                     const std::vector<std::uint32_t>& materials,
                                     const std::vector<std::uint32_t>& part_of_vertex) {
    std::vector<std::uint32_t> bodies = materials;
    const auto above = materials.empty() ? 0U : *std::ranges::max_element(materials) + 1;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const bool named = !groups.empty() && !groups[mesh.triangle_group[i]].material.empty();
        if (!named) bodies[i] = above + part_of_vertex[mesh.triangles[i].x];
    }
    return bodies;
}

std::vector<std::uint32_t> objects_of(const WeldedMesh& mesh) {
    std::vector<std::uint32_t> objects;
    if (mesh.object_ends.size() < 2) return objects;
    objects.reserve(mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles) {
        const auto end = std::ranges::upper_bound(mesh.object_ends, t.x);
        objects.push_back(static_cast<std::uint32_t>(end - mesh.object_ends.begin()));
    }
    return objects;
}

} // namespace lineatlas
