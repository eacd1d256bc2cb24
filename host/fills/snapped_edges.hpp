#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace lineatlas {

/// A place of a fixed grid finer than pixels: pixels times GridScale::per_pixel.
using GridPlace = glm::i64vec2;

/// The grid of a picture: so fine that products of places fit 62 bits.
struct GridScale {
    explicit GridScale(glm::ivec2 size);

    GridPlace place(glm::dvec2 pixels) const;
    glm::dvec2 pixels(GridPlace place) const { return glm::dvec2{place} / per_pixel; }

    double per_pixel;
};

/// Twice the area of the triangle a, b, c; above 0 if it goes round from x towards y.
inline std::int64_t twice_area(GridPlace a, GridPlace b, GridPlace c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A straight line between two places.
struct GridLine {
    GridPlace a, b;
};

/// Lines that meet at their ends alone.
struct SnappedEdges {
    struct Edge {
        std::uint32_t a, b; ///< indices into `places`, a < b

        auto operator<=>(const Edge&) const = default;
    };
    std::vector<GridPlace> places; ///< in order of x, then y
    std::vector<Edge> edges;       ///< in ascending order, none twice
};

/// Divides lines where they cross, and moves what is divided to the grid by snap rounding (Hobby:
/// Practical segment intersection with finite precision output, 1999): a line goes through the
/// middle of each cell that it passes and that holds an end or a crossing. `size`: of the picture.
SnappedEdges snap_lines(const std::vector<GridLine>& lines, glm::ivec2 size,
                        const GridScale& scale);

/// Leaves out edges with a free end, until no edge has one.
void drop_free_ends(SnappedEdges& edges);

} // namespace lineatlas
