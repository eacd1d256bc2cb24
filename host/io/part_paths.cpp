#include "part_paths.hpp"

#include <algorithm>
#include <map>

namespace lineatlas {

namespace {

/// The paths of parts, by the objects of a tree of parts.
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

template <class T>
void keep(std::vector<T>& values, const std::vector<bool>& kept) {
    if (values.empty()) return;
    std::size_t next = 0;
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (kept[i]) values[next++] = std::move(values[i]);
    values.resize(next);
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

void keep_parts(Mesh& mesh, const PartPaths& paths, const std::vector<bool>& wanted,
                bool loose_lines) {
    const auto kept = [&](const std::vector<std::uint32_t>& parts) {
        std::vector<bool> result;
        result.reserve(parts.size());
        for (const std::uint32_t part : parts)
            result.push_back(part == PartPaths::none ? loose_lines : wanted[part]);
        return result;
    };
    const std::vector<bool> triangles = kept(paths.of_triangle), lines = kept(paths.of_polyline);
    keep(mesh.triangles, triangles);
    keep(mesh.triangle_group, triangles);
    keep(mesh.triangle_object, triangles);
    if (!mesh.corner_normals.empty()) {
        std::vector<bool> corners;
        corners.reserve(3 * triangles.size());
        for (const bool triangle : triangles) corners.insert(corners.end(), 3, triangle);
        keep(mesh.corner_normals, corners);
    }
    keep(mesh.surfaces.of_triangle, triangles);
    keep(mesh.surfaces.parameters, triangles);
    keep(mesh.polylines, lines);
    keep(mesh.polyline_object, lines);
    keep(mesh.polyline_kind, lines);
}

} // namespace lineatlas
