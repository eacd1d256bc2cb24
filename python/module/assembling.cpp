#include "assembling.hpp"

namespace lineatlas::python {

void append(Mesh& mesh, const Mesh& part) {
    const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
    const auto groups = static_cast<std::uint32_t>(mesh.groups.size());
    const std::size_t triangles = mesh.triangles.size();
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    for (const glm::uvec3& t : part.triangles) mesh.triangles.push_back(t + vertices);
    mesh.groups.insert(mesh.groups.end(), part.groups.begin(), part.groups.end());
    if (mesh.groups.empty()) return;
    if (groups == 0 || part.groups.empty())
        mesh.groups.emplace_back(); // the group of meshes without groups
    const auto none = static_cast<std::uint32_t>(mesh.groups.size() - 1);
    mesh.triangle_group.resize(triangles, none);
    for (const std::uint32_t group : part.triangle_group)
        mesh.triangle_group.push_back(groups + group);
    mesh.triangle_group.resize(mesh.triangles.size(), none);
}

void shift_sources(LineSet& lines, std::uint32_t vertices, std::uint32_t triangles) {
    const auto shift = [](std::uint32_t& index, std::uint32_t by) {
        if (index != LineSource::none) index += by;
    };
    for (std::uint32_t& source : lines.vertex_sources) shift(source, vertices);
    for (std::uint32_t& source : lines.triangle_sources) shift(source, triangles);
    for (LineSource& source : lines.sources) {
        shift(source.from, vertices);
        shift(source.to, vertices);
        shift(source.triangle, triangles);
        shift(source.crossing, triangles);
    }
}

} // namespace lineatlas::python
