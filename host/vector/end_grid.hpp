#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace lineatlas {

/// A place where a pen may start a path.
struct PathEnd {
    glm::dvec2 at;
    std::uint32_t path;
    std::uint32_t point; ///< of the path
};

/// Finds the nearest of a set of places from which paths are taken one by one.
class EndGrid {
  public:
    EndGrid(std::vector<PathEnd> ends, std::size_t paths);

    /// The nearest place of a path that has not been taken.
    std::optional<PathEnd> nearest(glm::dvec2 at);
    void take(std::uint32_t path);

  private:
    struct Cell {
        std::vector<std::uint32_t> ends;
    };
    glm::ivec2 cell_of(glm::dvec2 at) const;
    void search_cell(glm::ivec2 cell, glm::dvec2 at, std::optional<PathEnd>& best,
                     double& best_distance);
    void search_ring(glm::ivec2 centre, int radius, glm::dvec2 at, std::optional<PathEnd>& best,
                     double& best_distance);

    std::vector<PathEnd> ends_;
    std::vector<bool> taken_; ///< per path
    std::size_t left_;
    glm::dvec2 low_{0, 0};
    double cell_ = 1;
    glm::ivec2 count_{1, 1};
    std::vector<Cell> cells_;
};

} // namespace lineatlas
