#include "mesh_check.hpp"

#include <cmath>

#include "fuzz.hpp"
#include "io/mesh_source.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::fuzz {

namespace {

bool is_finite(glm::vec3 point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// What load_mesh() promises of a mesh.
void check(const Mesh& mesh) {
    expect(!mesh.empty(), "an empty mesh is no success");
    const std::size_t n = mesh.positions.size();
    for (const glm::uvec3& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            expect(triangle[corner] < n, "a corner beyond the positions");
            expect(is_finite(mesh.positions[triangle[corner]]), "a corner that is not finite");
        }
    }
    for (const auto& polyline : mesh.polylines) {
        for (const std::uint32_t point : polyline) {
            expect(point < n, "a polyline beyond the positions");
        }
    }
    expect(mesh.triangle_group.empty() || mesh.triangle_group.size() == mesh.triangles.size(),
           "groups for some of the triangles only");
    for (const std::uint32_t group : mesh.triangle_group) {
        expect(group < mesh.groups.size(), "a triangle in a group that is not there");
    }
}

} // namespace

void try_mesh(const std::filesystem::path& path) {
    try {
        const LoadedMesh loaded = parse_mesh(read_mesh_source(path)); // by no process of its own
        check(loaded.mesh);
        extract_lines(loaded.mesh);
    } catch (const FileError& error) {
        expect_good_refusal(error, path);
    }
}

} // namespace lineatlas::fuzz
