#include "snapped_edges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include <glm/common.hpp>

#include "base/parallel.hpp"
#include "vector/segment_grid.hpp"

namespace lineatlas {
namespace {

bool is_before(GridPlace a, GridPlace b) {
    return std::tuple{a.x, a.y} < std::tuple{b.x, b.y};
}

int sign(std::int64_t value) {
    return (value > 0) - (value < 0);
}

/// Where two lines cross within both.
std::optional<GridPlace> crossing(const GridLine& l, const GridLine& m) {
    const std::int64_t la = twice_area(m.a, m.b, l.a), lb = twice_area(m.a, m.b, l.b);
    if (sign(la) * sign(lb) >= 0) return {};
    if (sign(twice_area(l.a, l.b, m.a)) * sign(twice_area(l.a, l.b, m.b)) >= 0) return {};
    const double share = static_cast<double>(la) / static_cast<double>(la - lb);
    return l.a + GridPlace{glm::round(glm::dvec2{l.b - l.a} * share)};
}

/// Whether a line passes the cell around a place, borders included. In half units the cell goes
/// from -1 to 1.
bool passes(const GridLine& line, GridPlace place) {
    const GridPlace a = (line.a - place) * std::int64_t{2}, b = (line.b - place) * std::int64_t{2};
    if (std::max(a.x, b.x) < -1 || std::min(a.x, b.x) > 1 || std::max(a.y, b.y) < -1 ||
        std::min(a.y, b.y) > 1)
        return false;
    int above = 0, below = 0;
    for (const GridPlace corner :
         {GridPlace{-1, -1}, GridPlace{1, -1}, GridPlace{-1, 1}, GridPlace{1, 1}}) {
        const std::int64_t side = twice_area(a, b, corner);
        above += side > 0 ? 1 : 0;
        below += side < 0 ? 1 : 0;
    }
    return above < 4 && below < 4;
}

/// Lines by the cells of a coarse grid.
class LineGrid {
  public:
    LineGrid(glm::ivec2 size, const GridScale& scale) : grid_(glm::dvec2{size}), scale_(scale) {}

    void insert(const GridLine& line, std::size_t id) {
        grid_.insert(scale_.pixels(line.a), scale_.pixels(line.b), static_cast<std::uint32_t>(id));
    }
    const std::vector<std::uint32_t>& near(const GridLine& line) {
        return grid_.near(scale_.pixels(line.a), scale_.pixels(line.b), 2 / scale_.per_pixel);
    }

  private:
    SegmentGrid grid_;
    const GridScale& scale_;
};

/// Ends and crossings, in order, none twice.
std::vector<GridPlace> hot_places(const std::vector<GridLine>& lines, LineGrid& grid) {
    std::vector<GridPlace> places;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ask_between_pieces();
        places.insert(places.end(), {lines[i].a, lines[i].b});
        for (const std::uint32_t other : grid.near(lines[i])) {
            if (const auto at = crossing(lines[i], lines[other])) places.push_back(*at);
        }
        grid.insert(lines[i], i);
    }
    std::ranges::sort(places, is_before);
    const auto equal = std::ranges::unique(places);
    places.erase(equal.begin(), equal.end());
    return places;
}

/// The hot places whose cells a line passes, in order along it.
std::vector<std::uint32_t> places_along(const GridLine& line, const std::vector<GridPlace>& places,
                                        LineGrid& grid) {
    std::vector<std::uint32_t> passed;
    for (const std::uint32_t id : grid.near(line))
        if (passes(line, places[id])) passed.push_back(id);
    const GridPlace way = line.b - line.a;
    std::ranges::sort(passed, {}, [&](std::uint32_t id) {
        const GridPlace to = places[id] - line.a;
        return std::pair{to.x * way.x + to.y * way.y, id};
    });
    return passed;
}

} // namespace

GridScale::GridScale(glm::ivec2 size) : per_pixel(1 << 14) {
    constexpr double most = 1 << 28;
    while (std::max(size.x, size.y) * per_pixel > most) per_pixel /= 2;
}

GridPlace GridScale::place(glm::dvec2 pixels) const {
    return GridPlace{glm::round(pixels * per_pixel)};
}

SnappedEdges snap_lines(const std::vector<GridLine>& lines, glm::ivec2 size,
                        const GridScale& scale) {
    SnappedEdges result;
    LineGrid line_grid{size, scale}, place_grid{size, scale};
    result.places = hot_places(lines, line_grid);
    for (std::size_t i = 0; i < result.places.size(); ++i)
        place_grid.insert({result.places[i], result.places[i]}, i);
    for (const GridLine& line : lines) {
        ask_between_pieces();
        const std::vector<std::uint32_t> along = places_along(line, result.places, place_grid);
        for (std::size_t i = 1; i < along.size(); ++i)
            result.edges.push_back(
                {std::min(along[i - 1], along[i]), std::max(along[i - 1], along[i])});
    }
    std::ranges::sort(result.edges);
    const auto equal = std::ranges::unique(result.edges);
    result.edges.erase(equal.begin(), equal.end());
    return result;
}

void drop_free_ends(SnappedEdges& edges) {
    // Per place the number of edges there, and the exclusive or of their indices. At a free end the
    // latter is the index of its edge.
    std::vector<std::uint32_t> count(edges.places.size(), 0), only(edges.places.size(), 0);
    for (std::uint32_t i = 0; i < edges.edges.size(); ++i) {
        for (const std::uint32_t end : {edges.edges[i].a, edges.edges[i].b}) {
            ++count[end];
            only[end] ^= i;
        }
    }
    std::vector<bool> dropped(edges.edges.size(), false);
    for (std::uint32_t start = 0; start < count.size(); ++start) {
        for (std::uint32_t at = start; count[at] == 1;) {
            const std::uint32_t edge = only[at];
            dropped[edge] = true;
            for (const std::uint32_t end : {edges.edges[edge].a, edges.edges[edge].b}) {
                --count[end];
                only[end] ^= edge;
            }
            at = edges.edges[edge].a == at ? edges.edges[edge].b : edges.edges[edge].a;
        }
    }
    std::size_t index = 0;
    std::erase_if(edges.edges, [&](const SnappedEdges::Edge&) { return dropped[index++]; });
}

} // namespace lineatlas
