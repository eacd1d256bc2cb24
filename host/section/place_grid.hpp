#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas {

/// Finds positions that are at one place: nearer to each other than a rounding in each coordinate.
/// Files may write 0 once and -3e-16 the next time.
class PlaceGrid {
  public:
    /// `positions` may grow, and must outlive it.
    PlaceGrid(const std::vector<glm::vec3>& positions, double rounding);

    void add(std::uint32_t index);

    /// Calls `each` for the positions at a place, until it returns true.
    template <class Each>
    void visit(glm::vec3 at, Each each) const {
        std::array<Cell, 8> near;
        const std::size_t count = cells_near(glm::dvec3{at}, near);
        for (std::size_t i = 0; i < count; ++i) {
            auto [entry, end] = cells_.equal_range(near[i]);
            for (; entry != end; ++entry)
                if (is_at(entry->second, glm::dvec3{at}) && each(entry->second)) return;
        }
    }

  private:
    using Cell = std::array<std::uint64_t, 3>;
    struct Hash {
        std::size_t operator()(const Cell& cell) const;
    };

    static Cell cell(glm::dvec3 corner);
    std::size_t cells_near(glm::dvec3 at, std::array<Cell, 8>& found) const;
    bool is_at(std::uint32_t index, glm::dvec3 at) const;

    const std::vector<glm::vec3>& positions_;
    double rounding_, width_; ///< of a cell; most positions lie far from a cell's border, and few
                              ///< share a cell
    std::unordered_multimap<Cell, std::uint32_t, Hash> cells_;
};

} // namespace lineatlas
