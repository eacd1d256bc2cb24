#include "lineatlas/volume.hpp"

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include <glm/geometric.hpp>

#include "base/first_seen.hpp"
#include "lineatlas/error.hpp"
#include "pair_key.hpp"

namespace lineatlas {
namespace {

/// Numbers places; equal places get the same number.
class Places {
  public:
    Places(std::span<const glm::vec3> positions, std::size_t most)
        : positions_(positions), seen_(most) {}

    std::uint32_t operator()(std::uint32_t index) {
        if (index >= positions_.size())
            throw UsageError("a triangle has the position " + std::to_string(index) +
                             ", but there are " + std::to_string(positions_.size()));
        const glm::vec3 at = positions_[index];
        return seen_.find_or_add(index, hash_of(at),
                                 [&](std::uint32_t other) { return positions_[other] == at; });
    }

  private:
    std::span<const glm::vec3> positions_;
    FirstSeen seen_;
};

/// True if along every edge as many triangles go one way as the other.
bool are_closed(const std::vector<glm::uvec3>& triangles) {
    std::unordered_map<std::uint64_t, int> ways;
    for (const glm::uvec3& t : triangles) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = t[k], to = t[(k + 1) % 3];
            if (from != to) ways[pair_key(from, to)] += from < to ? 1 : -1;
        }
    }
    for (const auto& [edge, sum] : ways)
        if (sum != 0) return false;
    return !triangles.empty();
}

} // namespace

std::optional<double> enclosed_volume(std::span<const glm::vec3> positions,
                                      std::span<const glm::uvec3> triangles) {
    Places place{positions, 3 * triangles.size()};
    std::vector<glm::uvec3> placed;
    for (const glm::uvec3& t : triangles) placed.push_back({place(t.x), place(t.y), place(t.z)});
    if (!are_closed(placed)) return std::nullopt;
    // The sum is about a point of the surface, so that precision stays far from zero.
    const glm::dvec3 origin{positions[placed.front().x]};
    double sum = 0;
    for (const glm::uvec3& t : placed) {
        const auto corner = [&](std::uint32_t index) {
            return glm::dvec3{positions[index]} - origin;
        };
        sum += glm::dot(corner(t.x), glm::cross(corner(t.y), corner(t.z))) / 6;
    }
    return sum;
}

std::optional<double> enclosed_volume(const Mesh& mesh) {
    return enclosed_volume(mesh.positions, mesh.triangles);
}

} // namespace lineatlas
