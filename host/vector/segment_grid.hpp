#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace lineatlas {

/// Straight lines on the screen, listed by the cells of a uniform grid that they pass. Lines
/// outside the picture belong to the cells at its border.
class SegmentGrid {
  public:
    /// For a picture of `size` pixels.
    explicit SegmentGrid(glm::dvec2 size);

    /// `id`: any small number; several lines may have the same.
    void insert(glm::dvec2 a, glm::dvec2 b, std::uint32_t id);

    /// The ids of all lines within `reach` of the line from a to b, and perhaps of others, each
    /// once. Valid until the next call.
    const std::vector<std::uint32_t>& near(glm::dvec2 a, glm::dvec2 b, double reach);

  private:
    struct Entry {
        std::uint32_t id, next;
    };

    int column_of(double x) const;
    int row_of(double y) const;
    template <class Visit>
    void for_cells(glm::dvec2 a, glm::dvec2 b, double reach, Visit&& visit) const;

    double cell_;
    int columns_, rows_;
    std::vector<std::uint32_t> first_; ///< per cell, its list in `entries_`
    std::vector<Entry> entries_;
    std::vector<std::uint32_t> seen_; ///< per id, the last query that found it
    std::uint32_t query_ = 0;
    std::vector<std::uint32_t> found_;
};

} // namespace lineatlas
