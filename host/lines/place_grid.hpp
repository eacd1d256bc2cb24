#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas {

/// The cell of a cubic grid that a place is in.
struct GridCell {
    std::int32_t x, y, z;
    bool operator==(const GridCell&) const = default;
    static GridCell of(glm::vec3 place, float size);
};
struct GridCellHash {
    std::size_t operator()(const GridCell& cell) const;
};

/// Places, each with a reach.
class PlaceGrid {
  public:
    void add(glm::vec3 place, float reach);
    /// Whether any of the places reaches `place`.
    bool near(glm::vec3 place) const;

  private:
    struct Entry {
        glm::vec3 place;
        float reach;
    };
    /// Places of about one reach: cells are twice as large, or a little more.
    struct Level {
        float size;
        std::unordered_map<GridCell, std::vector<Entry>, GridCellHash> cells{};
    };
    static bool near(const Level& level, glm::vec3 place);

    std::vector<Level> levels_;
};

/// Means of a value about places.
class MeanGrid {
  public:
    /// Forgets all; cells are of this size.
    void start(float size);
    void add(glm::vec3 place, float value, float weight);
    /// The mean over a place's cell and, with less weight, over the cells around it.
    float about(glm::vec3 place);

  private:
    struct Sum {
        double value = 0, weight = 0;
    };
    Sum around(const GridCell& cell) const;

    float size_ = 1;
    std::unordered_map<GridCell, Sum, GridCellHash> sums_;
    std::unordered_map<GridCell, float, GridCellHash> means_;
};

} // namespace lineatlas
