#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace lineatlas {

/// Points of a picture in cells, to ask whether one is near.
class PointGrid {
  public:
    static constexpr double most_reach = 2; ///< pixels

    /// `bars`: how far each point stretches to either side, for distance(); empty: not at all.
    PointGrid(std::span<const glm::vec2> points, glm::ivec2 picture,
              std::span<const glm::vec2> bars = {});

    /// Whether a point lies within `reach` pixels, at most `most_reach`.
    bool any_within(glm::dvec2 at, double reach) const;
    /// The distance to the nearest bar of a point within `reach`; infinite if there is none.
    double distance(glm::dvec2 at, double reach) const;

  private:
    glm::ivec2 cell(glm::dvec2 at) const;
    /// Calls `use` with the number of every point in the cells about a place, until it returns
    /// true.
    template <class Use>
    bool any_about(glm::dvec2 at, const Use& use) const;

    glm::ivec2 cells_;
    std::vector<std::uint32_t> first_; ///< point of each cell, then their number
    std::vector<glm::vec2> points_;    ///< by cell
    std::vector<glm::vec2> bars_;      ///< in the order of points_
};

} // namespace lineatlas
