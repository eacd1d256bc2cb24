#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas {

/// Disjoint sets of vertices, or of other numbered things.
class VertexSets {
  public:
    explicit VertexSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    /// The member that names the set of i.
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// Unites the sets of a and b. Returns the name of the new set, the lesser of both names.
    std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a > b) std::swap(a, b);
        return parent_[b] = a;
    }

  private:
    std::vector<std::uint32_t> parent_;
};

/// The sets of `count` vertices that triangles join.
inline VertexSets joined_by(std::span<const glm::uvec3> triangles, std::size_t count) {
    VertexSets sets{count};
    for (const glm::uvec3& t : triangles) {
        sets.unite(t.x, t.y);
        sets.unite(t.y, t.z);
    }
    return sets;
}

} // namespace lineatlas
