#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>

#include "groups.hpp"

namespace lineatlas {

/// Items that each lie between two vertices, as edges do, found by these vertices.
class VertexPairs {
  public:
    struct Item {
        std::uint32_t other; ///< the larger vertex
        std::uint32_t index; ///< of the item
        auto operator<=>(const Item&) const = default;
    };

    /// `ends_of(i)` returns the vertices of item i below `count` in either order, each below
    /// `vertices`, or nothing if the item is left out. Several threads call it.
    template <class EndsOf>
    VertexPairs(std::size_t vertices, std::size_t count, const EndsOf& ends_of)
        : items_{vertices, count, [&](std::size_t i, const auto& add) {
                     if (const std::optional<glm::uvec2> ends = ends_of(i))
                         add(std::min(ends->x, ends->y),
                             Item{std::max(ends->x, ends->y), static_cast<std::uint32_t>(i)});
                 }} {
        for_each_index(vertices, [&](std::size_t v) { std::ranges::sort(items_[v]); });
    }

    /// The range of items between two vertices, by index.
    auto between(std::uint32_t p, std::uint32_t q) const {
        return std::ranges::equal_range(items_[std::min(p, q)], std::max(p, q), {}, &Item::other);
    }

  private:
    Groups<Item> items_; ///< by the smaller vertex, each sorted
};

} // namespace lineatlas
