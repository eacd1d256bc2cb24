#include "seen_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "base/parallel.hpp"

namespace lineatlas {
namespace {

constexpr int least_tile = 16; ///< pixels

/// A picture has no more tiles along a side: what the lists of triangles take grows with the number
/// of tiles, not with that of pixels.
constexpr int most_tiles = 256;

/// A grid of tiles over the picture.
struct Tiles {
    explicit Tiles(glm::ivec2 size)
        : side(std::max(least_tile, rounded_up(std::max(size.x, size.y), most_tiles))),
          count{rounded_up(size.x, side), rounded_up(size.y, side)} {}

    /// The column and row of the tile at a place, or of the nearest tile.
    glm::ivec2 at(glm::dvec2 pixels) const {
        const glm::dvec2 place = glm::floor(pixels / static_cast<double>(side));
        return glm::ivec2{glm::clamp(place, glm::dvec2{0}, glm::dvec2{count - 1})};
    }
    std::size_t index(glm::ivec2 at) const {
        return static_cast<std::size_t>(at.y) * static_cast<std::size_t>(count.x) +
               static_cast<std::size_t>(at.x);
    }
    std::size_t size() const {
        return static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y);
    }

    int side; ///< pixels
    glm::ivec2 count;

  private:
    static int rounded_up(int pixels, int by) { return (pixels + by - 1) / by; }
};

/// Numbers by tiles, in ascending order in each.
struct TileLists {
    std::vector<std::size_t> first; ///< per tile, and one behind the last, into `list`
    std::vector<std::uint32_t> list;

    std::span<std::uint32_t> of(std::size_t tile) {
        return std::span{list}.subspan(first[tile], first[tile + 1] - first[tile]);
    }
};

/// `for_each_tile(i, each)` calls `each` with the tiles of number i.
template <class ForEachTile>
TileLists list_by_tiles(std::size_t tiles, std::size_t numbers, const ForEachTile& for_each_tile) {
    TileLists lists{std::vector<std::size_t>(tiles + 1, 0), {}};
    for (std::size_t i = 0; i < numbers; ++i)
        for_each_tile(i, [&](std::size_t at) { ++lists.first[at + 1]; });
    std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
    lists.list.resize(lists.first.back());
    std::vector<std::size_t> next = lists.first;
    for (std::size_t i = 0; i < numbers; ++i) {
        if (i % usual_piece == 0) ask_between_pieces();
        for_each_tile(
            i, [&](std::size_t at) { lists.list[next[at]++] = static_cast<std::uint32_t>(i); });
    }
    return lists;
}

/// A triangle before the camera, in homogeneous coordinates: nothing needs to be cut at the near
/// plane (Olano and Greer: Triangle scan conversion using 2D homogeneous coordinates, 1997).
class ShownTriangle {
  public:
    explicit ShownTriangle(const std::array<glm::dvec4, 3>& corners) : corners_(corners) {
        const auto plane = [&](int k) {
            const glm::dvec4 &a = corners_[static_cast<std::size_t>((k + 1) % 3)],
                             &b = corners_[static_cast<std::size_t>((k + 2) % 3)];
            return glm::cross(glm::dvec3{a.x, a.y, a.w}, glm::dvec3{b.x, b.y, b.w});
        };
        for (int k = 0; k < 3; ++k) sides_[static_cast<std::size_t>(k)] = plane(k);
        const glm::dvec4& first = corners_[0];
        determinant_ = glm::dot(sides_[0], glm::dvec3{first.x, first.y, first.w});
        for (glm::dvec3& side : sides_) side /= determinant_;
    }

    /// Whether part of it may be in the picture: it has an area, and does not lie beyond one of the
    /// sides of what the camera sees.
    bool may_be_seen() const {
        const auto are_all = [&](const auto& beyond) {
            return std::ranges::all_of(corners_, beyond);
        };
        return determinant_ != 0 && !are_all([](glm::dvec4 c) { return c.x < -c.w; }) &&
               !are_all([](glm::dvec4 c) { return c.x > c.w; }) &&
               !are_all([](glm::dvec4 c) { return c.y < -c.w; }) &&
               !are_all([](glm::dvec4 c) { return c.y > c.w; }) &&
               !are_all([](glm::dvec4 c) { return c.z < -c.w; });
    }

    /// The box around it in device coordinates, from its least depth on; all there is if part of
    /// the triangle lies behind the eye.
    std::pair<glm::dvec3, glm::dvec3> box() const {
        constexpr double far = std::numeric_limits<double>::infinity();
        glm::dvec3 low{far}, high{-far};
        for (const glm::dvec4& corner : corners_) {
            if (!(corner.w > 0)) return {{-far, -far, -1}, glm::dvec3{far}};
            low = glm::min(low, glm::dvec3{corner} / corner.w);
            high = glm::max(high, glm::dvec3{corner} / corner.w);
        }
        return {low, high};
    }

    /// Its depth, -1 near to 1 far, at a place in device coordinates.
    std::optional<double> depth_at(glm::dvec2 place) const {
        double depth = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double share = glm::dot(sides_[k], glm::dvec3{place, 1});
            if (!(share >= 0)) return {};
            depth += share * corners_[k].z;
        }
        return depth >= -1 ? std::optional{depth} : std::nullopt;
    }

  private:
    std::array<glm::dvec4, 3> corners_;
    std::array<glm::dvec3, 3> sides_{};
    double determinant_ = 0;
};

class Scene {
  public:
    Scene(const LineSet& lines, const Camera& camera, std::span<const glm::dvec2> points)
        : lines_(lines), size_(camera.size), points_(points), tiles_(camera.size),
          clip_(lines.vertices.size()) {
        const glm::dmat4 clip_from_world = glm::dmat4{camera.projection} * glm::dmat4{camera.view};
        for_each_index(clip_.size(), [&](std::size_t i) {
            clip_[i] = clip_from_world * glm::dvec4{glm::dvec3{lines.vertices[i]}, 1};
        });
        find_boxes();
        points_of_ = list_by_tiles(tiles_.size(), points.size(), [&](std::size_t i, auto&& each) {
            each(tiles_.index(tiles_.at(points[i])));
        });
        triangles_of_ =
            list_by_tiles(tiles_.size(), boxes_.size(),
                          [&](std::size_t i, auto&& each) { for_each_tile(boxes_[i], each); });
    }

    std::vector<std::uint32_t> look() {
        std::vector<std::uint32_t> seen(points_.size(), no_triangle);
        for_each_index(
            tiles_.size(), [&](std::size_t i) { look_at_tile(i, seen); }, 1);
        return seen;
    }

  private:
    struct Box {
        glm::dvec2 low, high; ///< pixels; empty if nothing is seen of it
        double nearest;       ///< depth
    };

    void find_boxes() {
        boxes_.resize(lines_.triangles.size());
        for_each_index(boxes_.size(), [&](std::size_t i) {
            const ShownTriangle triangle = shown(lines_.triangles[i]);
            const auto [low, high] = triangle.box();
            boxes_[i] = {pixels({low.x, high.y}), pixels({high.x, low.y}), low.z};
            if (!triangle.may_be_seen()) boxes_[i].high = boxes_[i].low - 1.0;
        });
    }

    template <class Each>
    void for_each_tile(const Box& box, Each&& each) const {
        const bool is_beside = box.high.x < 0 || box.high.y < 0 || box.low.x > size_.x ||
                               box.low.y > size_.y || !(box.low.x <= box.high.x);
        if (is_beside) return;
        const glm::ivec2 from = tiles_.at(box.low), to = tiles_.at(box.high);
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x) each(tiles_.index({x, y}));
    }

    /// Takes the triangles of a tile front to back, until none can be nearer than what is seen. The
    /// first of equal depth is seen.
    void look_at_tile(std::size_t index, std::vector<std::uint32_t>& seen) {
        const std::span<std::uint32_t> points = points_of_.of(index);
        if (points.empty()) return;
        const std::span<std::uint32_t> triangles = triangles_of_.of(index);
        std::ranges::sort(triangles, {}, [&](std::uint32_t i) {
            return std::pair{boxes_[i].nearest, i};
        });
        std::ranges::sort(points, {}, [&](std::uint32_t point) { return points_[point].y; });
        std::vector<double> columns, heights; // side by side, since most are only passed over
        for (const std::uint32_t point : points) {
            columns.push_back(points_[point].x);
            heights.push_back(points_[point].y);
        }
        std::vector<double> depths(points.size(), std::numeric_limits<double>::infinity());
        constexpr std::size_t often = 64; // triangles
        for (std::size_t n = 0; n < triangles.size(); ++n) {
            const std::uint32_t i = triangles[n];
            const Box& box = boxes_[i];
            if (n % often == 0 && box.nearest > *std::ranges::max_element(depths)) break;
            const auto row = [&](auto at) {
                return static_cast<std::size_t>(at - heights.begin());
            };
            const std::size_t first = row(std::ranges::lower_bound(heights, box.low.y));
            const std::size_t end = row(std::ranges::upper_bound(heights, box.high.y));
            std::optional<ShownTriangle> triangle; // most boxes have no point that asks for it
            for (std::size_t k = first; k < end; ++k) {
                const bool reaches = columns[k] >= box.low.x && columns[k] <= box.high.x;
                if (box.nearest > depths[k] || !reaches) continue;
                if (!triangle) triangle = shown(lines_.triangles[i]);
                const auto depth = triangle->depth_at(device({columns[k], heights[k]}));
                std::uint32_t& own = seen[points[k]];
                if (!depth || *depth > depths[k] || (*depth == depths[k] && i > own)) continue;
                depths[k] = *depth;
                own = i;
            }
        }
    }

    ShownTriangle shown(glm::uvec3 t) const {
        return ShownTriangle{{clip_[t.x], clip_[t.y], clip_[t.z]}};
    }
    glm::dvec2 device(glm::dvec2 pixels) const {
        const glm::dvec2 share = pixels / size_;
        return {2 * share.x - 1, 1 - 2 * share.y};
    }
    glm::dvec2 pixels(glm::dvec2 device) const {
        return {(device.x + 1) * 0.5 * size_.x, (1 - device.y) * 0.5 * size_.y};
    }

    const LineSet& lines_;
    glm::dvec2 size_;
    std::span<const glm::dvec2> points_;
    Tiles tiles_;
    std::vector<glm::dvec4> clip_; ///< per vertex, before the camera
    std::vector<Box> boxes_;       ///< per triangle
    TileLists points_of_, triangles_of_;
};

} // namespace

std::vector<std::uint32_t> seen_triangles(const LineSet& lines, const Camera& camera,
                                          std::span<const glm::dvec2> points) {
    return Scene{lines, camera, points}.look();
}

} // namespace lineatlas
