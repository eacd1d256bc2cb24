#include "background.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "base/parallel.hpp"
#include "base/vertex_sets.hpp"

namespace lineatlas {
namespace {

constexpr int most_texels = 2048; ///< along an axis

double texel_for(glm::ivec2 picture) {
    return std::max(1.0, static_cast<double>(std::max(picture.x, picture.y)) / most_texels);
}

/// The part of a triangle beyond the near plane.
struct Polygon {
    std::array<glm::dvec2, 4> corners;
    std::size_t count = 0;

    void add(glm::dvec2 corner) { corners[count++] = corner; }
    std::span<const glm::dvec2> places() const { return std::span{corners}.first(count); }
};

/// Where faces lie on the grid, beyond the near plane.
class Projector {
  public:
    Projector(const Camera& camera, double texel)
        : clip_from_world_(glm::dmat4{camera.projection} * glm::dmat4{camera.view}),
          half_size_(0.5 / texel * glm::dvec2{camera.size}) {}

    glm::dvec4 clip(glm::vec3 world) const {
        return clip_from_world_ * glm::dvec4{glm::dvec3{world}, 1};
    }
    /// Not for points in front of the near plane.
    std::optional<glm::dvec2> place(glm::dvec4 clip) const {
        if (before_near(clip) < 0 || !(clip.w > 0)) return std::nullopt;
        return half_size_ * glm::dvec2{1 + clip.x / clip.w, 1 - clip.y / clip.w};
    }
    Polygon polygon(const std::array<glm::dvec4, 3>& corners) const {
        Polygon places;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec4 a = corners[i], b = corners[(i + 1) % 3];
            const double from = before_near(a), to = before_near(b);
            if (const auto at = place(a)) places.add(*at);
            if ((from < 0) == (to < 0)) continue;
            const glm::dvec4 crossing = a + (b - a) * (from / (from - to));
            if (crossing.w > 0)
                places.add(half_size_ *
                           glm::dvec2{1 + crossing.x / crossing.w, 1 - crossing.y / crossing.w});
        }
        return places;
    }

  private:
    static double before_near(glm::dvec4 clip) { return clip.z + clip.w; }

    glm::dmat4 clip_from_world_;
    glm::dvec2 half_size_;
};

/// Rows, or texels of a row: [first, end).
struct Range {
    int first, end;
};

/// The texels with their middles in an interval, within `limits`.
Range texels_in(double low, double high, Range limits) {
    const auto texel = [&](double at) {
        const double first = limits.first, end = limits.end;
        return static_cast<int>(std::clamp(std::ceil(at - 0.5), first, end));
    };
    return {texel(low), texel(high)};
}

/// The rows that a polygon may cover, of `height`.
Range rows_of(std::span<const glm::dvec2> polygon, int height) {
    constexpr double far = std::numeric_limits<double>::infinity();
    double top = far, bottom = -far;
    for (const glm::dvec2 corner : polygon) {
        top = std::min(top, corner.y);
        bottom = std::max(bottom, corner.y);
    }
    return texels_in(top, bottom, {0, height});
}

/// Calls span(row, texels) for what a convex polygon covers of some rows. Polygons with an edge in
/// common leave no texel between them.
template <class Span>
void for_each_span(std::span<const glm::dvec2> polygon, Range rows, int width, const Span& span) {
    constexpr double far = std::numeric_limits<double>::infinity();
    for (int y = rows.first; y < rows.end; ++y) {
        const double middle = y + 0.5;
        double low = far, high = -far;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
            if (a.y > b.y) std::swap(a, b);
            if (!(a.y <= middle && middle < b.y)) continue;
            const double x = a.x + (b.x - a.x) * ((middle - a.y) / (b.y - a.y));
            low = std::min(low, x);
            high = std::max(high, x);
        }
        if (low < high) span(y, texels_in(low, high, {0, width}));
    }
}

/// Background texels of a row side by side.
struct EmptyRun {
    Range texels;
    int row;
};

bool meet(const EmptyRun& a, const EmptyRun& b) {
    return a.texels.first < b.texels.end && b.texels.first < a.texels.end;
}

} // namespace

Background::Background(const LineSet& lines, const Camera& camera)
    : texel_(texel_for(camera.size)),
      size_(glm::max(glm::ivec2{glm::ceil(glm::dvec2{camera.size} / texel_)}, glm::ivec2{1})),
      texels_(row(size_.y), Ground::enclosed) {
    cover(lines, camera);
    find_regions();
}

Ground Background::at(glm::dvec2 place) const {
    const glm::dvec2 texel = glm::floor(place / texel_);
    if (!(texel.x >= 0 && texel.y >= 0 && texel.x < size_.x && texel.y < size_.y))
        return Ground::around;
    return texels_[row(static_cast<int>(texel.y)) + static_cast<std::size_t>(texel.x)];
}

void Background::cover(const LineSet& lines, const Camera& camera) {
    const Projector projector{camera, texel_};
    std::vector<std::optional<glm::dvec2>> places(lines.vertices.size());
    for_each_index(places.size(), [&](std::size_t i) {
        places[i] = projector.place(projector.clip(lines.vertices[i]));
    });
    const auto polygon_of = [&](const glm::uvec3& corners) -> Polygon {
        const auto &a = places[corners.x], &b = places[corners.y], &c = places[corners.z];
        if (!a && !b && !c) return {};
        if (a && b && c) return {.corners = {*a, *b, *c}, .count = 3};
        return projector.polygon({projector.clip(lines.vertices[corners.x]),
                                  projector.clip(lines.vertices[corners.y]),
                                  projector.clip(lines.vertices[corners.z])});
    };
    std::vector<Range> rows(lines.triangles.size());
    for_each_index(rows.size(), [&](std::size_t i) {
        rows[i] = rows_of(polygon_of(lines.triangles[i]).places(), size_.y);
    });
    constexpr std::size_t band = 256; // rows; every band looks at all triangles
    for_each_piece(
        static_cast<std::size_t>(size_.y), band, [&](std::size_t first, std::size_t end) {
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const Range own{std::max(rows[i].first, static_cast<int>(first)),
                                std::min(rows[i].end, static_cast<int>(end))};
                if (own.first >= own.end) continue;
                for_each_span(polygon_of(lines.triangles[i]).places(), own, size_.x,
                              [&](int y, Range texels) {
                                  std::fill(&texels_[row(y)] + texels.first,
                                            &texels_[row(y)] + texels.end, Ground::model);
                              });
            }
        });
}

void Background::find_regions() {
    std::vector<EmptyRun> runs;
    std::vector<std::size_t> first_of_row;
    for (int y = 0; y < size_.y; ++y) {
        first_of_row.push_back(runs.size());
        for (int x = 0; x < size_.x; ++x) {
            if (texels_[row(y) + static_cast<std::size_t>(x)] == Ground::model) continue;
            if (x > 0 && runs.size() > first_of_row.back() && runs.back().texels.end == x)
                ++runs.back().texels.end;
            else
                runs.push_back({.texels = {x, x + 1}, .row = y});
        }
    }
    first_of_row.push_back(runs.size());
    // The last set is what lies beyond the picture's border.
    const auto beyond = static_cast<std::uint32_t>(runs.size());
    VertexSets regions{runs.size() + 1};
    for (std::uint32_t i = 0; i < beyond; ++i) {
        const EmptyRun& run = runs[i];
        if (run.row == 0 || run.row + 1 == size_.y || run.texels.first == 0 ||
            run.texels.end == size_.x)
            regions.unite(i, beyond);
        if (run.row == 0) continue;
        const auto above = static_cast<std::size_t>(run.row) - 1;
        for (std::size_t k = first_of_row[above]; k < first_of_row[above + 1]; ++k)
            if (meet(run, runs[k])) regions.unite(i, static_cast<std::uint32_t>(k));
    }
    for (std::uint32_t i = 0; i < beyond; ++i) {
        if (regions.find(i) != regions.find(beyond)) continue;
        const Range texels = runs[i].texels;
        std::fill(&texels_[row(runs[i].row)] + texels.first,
                  &texels_[row(runs[i].row)] + texels.end, Ground::around);
    }
}

} // namespace lineatlas
