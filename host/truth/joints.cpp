#include "joints.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "vector/paths.hpp"
#include "vector/segment_grid.hpp"

namespace lineatlas {
namespace {

constexpr double widest = 1;
constexpr double rounding = 0.02;

struct End {
    glm::dvec2 at;
    std::uint32_t path;
};

/// Where the paths of a drawing are.
class PathGrid {
  public:
    PathGrid(const DrawnLines& drawn, glm::ivec2 picture)
        : drawn_(drawn), grid_(glm::dvec2{picture}), path_of_(drawn.legs.size()) {
        for (std::uint32_t path = 0, leg = 0; path < drawn.path_ends.size(); ++path)
            for (; leg < drawn.path_ends[path]; ++leg) {
                path_of_[leg] = path;
                grid_.insert(drawn.legs[leg].from, drawn.legs[leg].to, leg);
            }
    }

    bool meets_another(const End& end) {
        return std::ranges::any_of(grid_.near(end.at, end.at, rounding), [&](std::uint32_t leg) {
            const DrawnPiece& piece = drawn_.legs[leg];
            return path_of_[leg] != end.path &&
                   distance_to(end.at, piece.from, piece.to) <= rounding;
        });
    }

  private:
    const DrawnLines& drawn_;
    SegmentGrid grid_;
    std::vector<std::uint32_t> path_of_; ///< per leg
};

} // namespace

std::vector<Gap> gaps_of(const DrawnLines& drawn, glm::ivec2 picture) {
    PathGrid paths{drawn, picture};
    std::vector<End> loose;
    std::size_t first = 0;
    for (std::uint32_t path = 0; path < drawn.path_ends.size(); ++path) {
        const std::size_t end = drawn.path_ends[path];
        if (first < end && drawn.legs[first].from != drawn.legs[end - 1].to)
            for (const glm::dvec2 at : {drawn.legs[first].from, drawn.legs[end - 1].to})
                if (const End one{at, path}; !paths.meets_another(one)) loose.push_back(one);
        first = end;
    }
    std::ranges::sort(loose, {}, [](const End& end) { return end.at.x; });
    std::vector<Gap> gaps;
    for (auto a = loose.begin(); a != loose.end(); ++a)
        for (auto b = a + 1; b != loose.end() && b->at.x - a->at.x < widest; ++b)
            if (const double width = glm::distance(a->at, b->at);
                width < widest && a->path != b->path)
                gaps.push_back({glm::vec2{a->at}, static_cast<float>(width)});
    std::ranges::stable_sort(gaps, std::ranges::greater{}, &Gap::width);
    return gaps;
}

} // namespace lineatlas
