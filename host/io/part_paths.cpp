#include "part_paths.hpp"

#include <algorithm>
#include <map>

namespace lineatlas {

namespace {

/// By the objects of a tree of parts.
PartPaths of_tree(const LoadedMesh& loaded) {
    PartPaths result{.paths = {},
                     .of_triangle = loaded.mesh.triangle_object,
                     .of_polyline = loaded.mesh.polyline_object};
    std::uint32_t count = 0;
    for (const std::uint32_t object : result.of_triangle) count = std::max(count, object + 1);
    for (const std::uint32_t object : result.of_polyline) count = std::max(count, object + 1);
    result.paths.resize(count);
    for (const ModelPart& part : loaded.parts) {
        if (part.object >= count) continue;
        std::vector<std::string>& names = result.paths[part.object].names;
        names = {part.name};
        for (std::uint32_t above = part.parent; above != ModelPart::none;
             above = loaded.parts[above].parent)
            names.push_back(loaded.parts[above].name);
        std::ranges::reverse(names);
    }
    return result;
}

PartPaths of_groups(const Mesh& mesh) {
    PartPaths result;
    std::map<std::string, std::uint32_t> known;
    std::vector<std::uint32_t> of_group;
    for (const MeshGroup& group : mesh.groups) {
        const auto fresh = static_cast<std::uint32_t>(result.paths.size());
        const auto [entry, is_new] = known.try_emplace(group.object, fresh);
        if (is_new) result.paths.push_back({.names = {group.object}});
        of_group.push_back(entry->second);
    }
    for (const std::uint32_t group : mesh.triangle_group)
        result.of_triangle.push_back(of_group[group]);
    if (mesh.triangle_group.empty()) {
        result.paths.push_back({.names = {""}});
        result.of_triangle.assign(mesh.triangles.size(), 0);
    }
    result.of_polyline.assign(mesh.polylines.size(), PartPaths::none);
    return result;
}

} // namespace

std::string PartPath::whole() const {
    std::string path;
    for (const std::string& name : names) path += (&name == names.data() ? "" : "/") + name;
    return path;
}

PartPaths part_paths(const LoadedMesh& loaded) {
    return loaded.parts.empty() ? of_groups(loaded.mesh) : of_tree(loaded);
}

} // namespace lineatlas
