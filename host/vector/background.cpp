#include "background.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

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

/// The faces of a model on the grid.
class Raster {
  public:
    Raster(const LineSet& lines, const Camera& camera, double texel, glm::ivec2 size)
        : lines_(lines), projector_(camera, texel), size_(size), places_(lines.vertices.size()),
          rows_(lines.triangles.size()) {
        for_each_index(places_.size(), [&](std::size_t i) {
            places_[i] = projector_.place(projector_.clip(lines.vertices[i]));
        });
        for_each_index(rows_.size(), [&](std::size_t i) {
            rows_[i] = rows_of(polygon_of(lines.triangles[i]).places(), size.y);
        });
    }

    /// Calls span(band, triangle, row, texels) for what triangles cover, at the same time for
    /// different bands of rows, which follow each other.
    template <class Span>
    void for_each_span_of_bands(const Span& span) const {
        for_each_piece(
            static_cast<std::size_t>(size_.y), band, [&](std::size_t first, std::size_t end) {
                for (std::size_t i = 0; i < rows_.size(); ++i) {
                    const Range own{std::max(rows_[i].first, static_cast<int>(first)),
                                    std::min(rows_[i].end, static_cast<int>(end))};
                    if (own.first >= own.end) continue;
                    for_each_span(polygon_of(lines_.triangles[i]).places(), own, size_.x,
                                  [&](int y, Range texels) { span(first / band, i, y, texels); });
                }
            });
    }
    std::size_t bands() const { return (static_cast<std::size_t>(size_.y) + band - 1) / band; }

  private:
    static constexpr std::size_t band = 256; ///< rows; every band looks at all triangles

    Polygon polygon_of(const glm::uvec3& corners) const {
        const auto &a = places_[corners.x], &b = places_[corners.y], &c = places_[corners.z];
        if (!a && !b && !c) return {};
        if (a && b && c) return {.corners = {*a, *b, *c}, .count = 3};
        return projector_.polygon({projector_.clip(lines_.vertices[corners.x]),
                                   projector_.clip(lines_.vertices[corners.y]),
                                   projector_.clip(lines_.vertices[corners.z])});
    }

    const LineSet& lines_;
    Projector projector_;
    glm::ivec2 size_;
    std::vector<std::optional<glm::dvec2>> places_;
    std::vector<Range> rows_; ///< of triangles
};

/// Background texels of a row side by side, and their region.
struct EmptyRun {
    Range texels;
    int row;
    std::uint32_t region = 0;
};

bool meet(const EmptyRun& a, const EmptyRun& b) {
    return a.texels.first < b.texels.end && b.texels.first < a.texels.end;
}

/// Runs of a row after those of the rows above. Their regions are numbered by one of their runs;
/// those that reach the border have the number of none.
std::vector<EmptyRun> find_regions(std::vector<EmptyRun> runs, glm::ivec2 size) {
    // The last set is what lies beyond the picture's border.
    const auto beyond = static_cast<std::uint32_t>(runs.size());
    VertexSets regions{runs.size() + 1};
    std::uint32_t above = 0; // the first run that may meet the next one
    for (std::uint32_t i = 0; i < beyond; ++i) {
        const EmptyRun& run = runs[i];
        if (run.row == 0 || run.row + 1 == size.y || run.texels.first == 0 ||
            run.texels.end == size.x)
            regions.unite(i, beyond);
        while (runs[above].row + 1 < run.row ||
               (runs[above].row + 1 == run.row && runs[above].texels.end <= run.texels.first))
            ++above;
        for (std::uint32_t k = above; runs[k].row + 1 == run.row && meet(run, runs[k]); ++k)
            regions.unite(i, k);
    }
    const std::uint32_t outside = regions.find(beyond);
    for (std::uint32_t i = 0; i < beyond; ++i) {
        const std::uint32_t region = regions.find(i);
        runs[i].region = region == outside ? beyond : region;
    }
    return runs;
}

/// The background that reaches no border of the picture, with its regions.
template <class IsModel>
std::vector<EmptyRun> inner_runs(glm::ivec2 size, const IsModel& is_model) {
    std::vector<EmptyRun> runs;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            if (is_model(x, y)) continue;
            if (!runs.empty() && runs.back().row == y && runs.back().texels.end == x)
                ++runs.back().texels.end;
            else
                runs.push_back({.texels = {x, x + 1}, .row = y});
        }
    }
    runs = find_regions(std::move(runs), size);
    std::erase_if(runs,
                  [outside = runs.size()](const EmptyRun& run) { return run.region == outside; });
    return runs;
}

/// A texel that a face covers beside a region of background that reaches no border.
struct BorderTexel {
    int row, column;
    std::uint32_t region;

    auto operator<=>(const BorderTexel&) const = default;
};

/// Ascending.
template <class IsModel>
std::vector<BorderTexel> border_of(const std::vector<EmptyRun>& runs, const IsModel& is_model) {
    std::vector<BorderTexel> border;
    for (const auto& [texels, row, region] : runs) {
        border.push_back({row, texels.first - 1, region});
        border.push_back({row, texels.end, region});
        for (int x = texels.first; x < texels.end; ++x) {
            for (const int y : {row - 1, row + 1})
                if (is_model(x, y)) border.push_back({y, x, region});
        }
    }
    std::ranges::sort(border);
    border.erase(std::ranges::unique(border).begin(), border.end());
    return border;
}

/// The regions, ascending, that one piece surrounds: it covers all of their border texels. `border`
/// is ascending.
std::vector<std::uint32_t> regions_in_one_piece(const std::vector<BorderTexel>& border,
                                                const Raster& raster, const LineSet& lines) {
    if (border.empty()) return {};
    VertexSets pieces = joined_by(lines.triangles, lines.vertices.size());
    std::vector<std::uint32_t> piece_of(lines.triangles.size());
    for (std::size_t i = 0; i < piece_of.size(); ++i)
        piece_of[i] = pieces.find(lines.triangles[i].x);
    using Covered = std::pair<std::uint32_t, std::uint32_t>; // place in `border`, piece
    std::vector<std::vector<Covered>> of_bands(raster.bands());
    raster.for_each_span_of_bands([&](std::size_t band, std::size_t triangle, int y, Range texels) {
        for (auto at = std::ranges::lower_bound(border, BorderTexel{y, texels.first, 0});
             at != border.end() && at->row == y && at->column < texels.end; ++at) {
            const Covered covered{static_cast<std::uint32_t>(at - border.begin()),
                                  piece_of[triangle]};
            std::vector<Covered>& own = of_bands[band];
            if (own.empty() || own.back() != covered) own.push_back(covered);
        }
    });
    std::vector<Covered> covered = joined(of_bands);
    std::ranges::sort(covered);
    const auto [first, last] = std::ranges::unique(covered);
    covered.erase(first, last);
    std::map<std::uint32_t, std::size_t> lengths; // of regions
    for (const BorderTexel& texel : border) ++lengths[texel.region];
    std::map<Covered, std::size_t> shares; // of a region and a piece
    for (const auto& [at, piece] : covered) ++shares[{border[at].region, piece}];
    std::vector<std::uint32_t> found;
    for (const auto& [of, length] : shares)
        if (length == lengths[of.first]) found.push_back(of.first);
    return found;
}

} // namespace

Background::Background(const LineSet& lines, const Camera& camera)
    : texel_(texel_for(camera.size)),
      size_(glm::max(glm::ivec2{glm::ceil(glm::dvec2{camera.size} / texel_)}, glm::ivec2{1})),
      texels_(index(0, size_.y), Ground::around) {
    const Raster raster{lines, camera, texel_, size_};
    raster.for_each_span_of_bands([&](std::size_t, std::size_t, int y, Range texels) {
        fill(y, texels.first, texels.end, Ground::model);
    });
    const auto is_model = [&](int x, int y) { return texels_[index(x, y)] == Ground::model; };
    const std::vector<EmptyRun> runs = inner_runs(size_, is_model);
    const std::vector<std::uint32_t> holes =
        regions_in_one_piece(border_of(runs, is_model), raster, lines);
    for (const EmptyRun& run : runs)
        if (std::ranges::binary_search(holes, run.region))
            fill(run.row, run.texels.first, run.texels.end, Ground::enclosed);
}

Ground Background::at(glm::dvec2 place) const {
    const glm::dvec2 texel = glm::floor(place / texel_);
    if (!(texel.x >= 0 && texel.y >= 0 && texel.x < size_.x && texel.y < size_.y))
        return Ground::around;
    return texels_[index(static_cast<int>(texel.x), static_cast<int>(texel.y))];
}

void Background::fill(int y, int first, int end, Ground ground) {
    std::fill(&texels_[index(0, y)] + first, &texels_[index(0, y)] + end, ground);
}

} // namespace lineatlas
