#include "joints.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>

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
    bool is_last; ///< of its path's two ends

    /// Tells all ends apart, so that every library sorts them alike.
    auto order() const { return std::tuple{at.x, at.y, path, is_last}; }
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

/// Per end, in order of x, the nearest end of another path within reach, or the number of ends.
std::vector<std::size_t> nearest_of(const std::vector<End>& ends) {
    std::vector<std::size_t> nearest(ends.size(), ends.size());
    std::vector<double> distances(ends.size(), widest);
    const auto note = [&](std::size_t one, std::size_t other, double distance) {
        if (!(distance < distances[one])) return;
        distances[one] = distance;
        nearest[one] = other;
    };
    for (std::size_t a = 0; a < ends.size(); ++a)
        for (std::size_t b = a + 1; b < ends.size() && ends[b].at.x - ends[a].at.x < widest; ++b) {
            if (ends[a].path == ends[b].path) continue;
            const double distance = glm::distance(ends[a].at, ends[b].at);
            note(a, b, distance);
            note(b, a, distance);
        }
    return nearest;
}

} // namespace

std::vector<Gap> gaps_of(const DrawnLines& drawn, glm::ivec2 picture) {
    PathGrid paths{drawn, picture};
    std::vector<End> loose;
    std::size_t first = 0;
    for (std::uint32_t path = 0; path < drawn.path_ends.size(); ++path) {
        const std::size_t end = drawn.path_ends[path];
        if (first < end && drawn.legs[first].from != drawn.legs[end - 1].to)
            for (const End& one : {End{drawn.legs[first].from, path, false},
                                   End{drawn.legs[end - 1].to, path, true}})
                if (!paths.meets_another(one)) loose.push_back(one);
        first = end;
    }
    std::ranges::sort(loose, {}, &End::order);
    const std::vector<std::size_t> nearest = nearest_of(loose);
    std::vector<Gap> gaps;
    for (std::size_t i = 0; i < loose.size(); ++i)
        if (nearest[i] > i && nearest[i] < loose.size() && nearest[nearest[i]] == i)
            gaps.push_back({glm::vec2{loose[i].at},
                            static_cast<float>(glm::distance(loose[i].at, loose[nearest[i]].at))});
    std::ranges::stable_sort(gaps, std::ranges::greater{}, &Gap::width);
    return gaps;
}

} // namespace lineatlas
