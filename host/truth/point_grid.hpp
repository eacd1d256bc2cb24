#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace lineatlas {

/// Points of a picture in cells, to ask whether one is near.
class PointGrid {
  public:
    static constexpr double most_reach = 2; ///< pixels

    PointGrid(std::vector<glm::vec2> points, glm::ivec2 picture);

    /// Whether a point lies within `reach` pixels, at most `most_reach`.
    bool any_within(glm::dvec2 at, double reach) const;

  private:
    glm::ivec2 cell(glm::dvec2 at) const;

    glm::ivec2 cells_;
    std::vector<std::uint32_t> first_; ///< point of each cell, then their number
    std::vector<glm::vec2> points_;    ///< by cell
};

} // namespace lineatlas
