#include "parts.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "base/vertex_sets.hpp"
#include "place_grid.hpp"

namespace lineatlas {
namespace {

/// A hash of three numbers.
struct TripleHash {
    std::size_t operator()(const std::array<std::uint32_t, 3>& bits) const {
        std::uint64_t h = bits[0] * 0x9E3779B97F4A7C15ULL;
        h ^= (std::uint64_t{bits[1]} << 32U | bits[2]) * 0xC2B2AE3D27D4EB4FULL;
        return static_cast<std::size_t>(h ^ h >> 29U);
    }
};

/// The object of each triangle, as the number of its name; 0: no object.
std::vector<std::uint32_t> objects_of(const Mesh& mesh) {
    std::map<std::string, std::uint32_t> numbers{{"", 0}};
    std::vector<std::uint32_t> of_group;
    for (const MeshGroup& group : mesh.groups)
        of_group.push_back(numbers.emplace(group.object, static_cast<std::uint32_t>(numbers.size()))
                               .first->second);
    std::vector<std::uint32_t> objects(mesh.triangles.size(), 0);
    for (std::size_t i = 0; i < mesh.triangle_group.size(); ++i)
        objects[i] = of_group[mesh.triangle_group[i]];
    return objects;
}

} // namespace

std::vector<std::uint32_t> place_numbers(const std::vector<glm::vec3>& positions, double rounding) {
    const auto count = static_cast<std::uint32_t>(positions.size());
    PlaceGrid grid{positions, rounding};
    VertexSets sets{count};
    for (std::uint32_t i = 0; i < count; ++i) {
        bool is_known = false; // a position exactly here is known, which has met all others
        grid.visit(positions[i], [&](std::uint32_t near) {
            sets.unite(near, i);
            return is_known = positions[near] == positions[i];
        });
        if (!is_known) grid.add(i);
    }
    std::vector<std::uint32_t> numbers(count);
    for (std::uint32_t i = 0; i < count; ++i) numbers[i] = sets.find(i);
    return numbers;
}

Parts find_parts(const Mesh& mesh, const std::vector<std::uint32_t>& places) {
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    const std::vector<std::uint32_t> objects = objects_of(mesh);
    VertexSets sets{count};
    // Objects that touch along an edge are not connected there.
    std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, TripleHash> triangle_at;
    triangle_at.reserve(2 * mesh.triangles.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t p = places[mesh.triangles[i][corner]];
            const std::uint32_t q = places[mesh.triangles[i][(corner + 1) % 3]];
            const auto [found, fresh] =
                triangle_at.emplace(std::array{std::min(p, q), std::max(p, q), objects[i]}, i);
            if (!fresh) sets.unite(found->second, i);
        }
    }
    Parts parts;
    parts.of_triangle.resize(count);
    std::map<std::uint32_t, std::uint32_t> looks; // per object
    std::vector<std::uint32_t> number(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t root = sets.find(i);
        if (root == i) {
            number[i] = static_cast<std::uint32_t>(parts.name.size());
            const bool named = objects[i] != 0;
            parts.name.push_back(named ? mesh.groups[mesh.triangle_group[i]].object : "");
            parts.look.push_back(named ? looks.emplace(objects[i], number[i]).first->second
                                       : number[i]);
        }
        parts.of_triangle[i] = number[root];
    }
    return parts;
}

} // namespace lineatlas
