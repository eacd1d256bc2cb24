#include "check_mesh.hpp"

#include <string>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

void check_index(std::size_t index, std::size_t count, const char* of, std::size_t place) {
    if (index < count) return;
    throw UsageError("mesh: " + std::string{of} + " " + std::to_string(place) + " has the index " +
                     std::to_string(index) + ", but there are " + std::to_string(count) +
                     " positions, counted from 0");
}

} // namespace

void check_indices(const Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner)
            check_index(mesh.triangles[i][corner], count, "triangle", i);
    }
    if (!mesh.polyline_kind.empty() && mesh.polyline_kind.size() != mesh.polylines.size())
        throw UsageError("mesh: there are " + std::to_string(mesh.polylines.size()) +
                         " polylines, but kinds for " + std::to_string(mesh.polyline_kind.size()));
    if (!mesh.corner_normals.empty() && mesh.corner_normals.size() != 3 * mesh.triangles.size())
        throw UsageError("mesh: there are " + std::to_string(mesh.triangles.size()) +
                         " triangles, which have three corners each, but normals of " +
                         std::to_string(mesh.corner_normals.size()) + " corners");
    if (!is_sound(mesh.surfaces, mesh.triangles.size()))
        throw UsageError("mesh: its surfaces do not fit its " +
                         std::to_string(mesh.triangles.size()) +
                         " triangles, or a number in them is out of range");
    for (std::size_t i = 0; i < mesh.polylines.size(); ++i) {
        for (const std::uint32_t index : mesh.polylines[i])
            check_index(index, count, "polyline", i);
    }
}

void check_groups(const Mesh& mesh) {
    if (mesh.triangle_group.empty() && mesh.groups.empty()) return;
    if (mesh.triangle_group.size() != mesh.triangles.size()) {
        throw UsageError("mesh: there are " + std::to_string(mesh.triangles.size()) +
                         " triangles, but groups for " +
                         std::to_string(mesh.triangle_group.size()));
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (mesh.triangle_group[i] < mesh.groups.size()) continue;
        throw UsageError("mesh: triangle " + std::to_string(i) + " is of group " +
                         std::to_string(mesh.triangle_group[i]) + ", but there are " +
                         std::to_string(mesh.groups.size()) + ", counted from 0");
    }
}

} // namespace lineatlas
