#include "smooth_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/plane_vectors.hpp"
#include "paths.hpp"

namespace lineatlas {
namespace {

constexpr double same_point = 1e-3; ///< pixels
constexpr double sharpest = 0.2;    ///< radians by which a smooth line turns from chord to chord

/// One of the two ends of a path.
struct End {
    glm::dvec2 at;
    std::uint32_t path;
    bool at_end;

    std::size_t number() const { return 2 * std::size_t{path} + (at_end ? 1 : 0); }
};

/// The ends of all paths, by place.
class EndsByPlace {
  public:
    EndsByPlace(const std::vector<VectorPath>& paths, const std::vector<End>& ends) {
        entries_.reserve(ends.size());
        for (const End& end : ends)
            entries_.push_back({paths[end.path].visible, cell_of(end.at), end});
        std::ranges::sort(entries_, {}, &Entry::order);
    }

    /// The end that is where another one is, if it is the only one. Hidden ends are not beside
    /// visible ones.
    std::optional<End> only_one_beside(const End& end, bool visible) const {
        std::optional<End> found;
        const auto [column, row] = cell_of(end.at);
        for (double x = column - 1; x <= column + 1; ++x) {
            auto entry = std::ranges::lower_bound(
                entries_, std::tuple{visible, x, row - 1, std::size_t{0}}, {}, &Entry::order);
            for (; entry != entries_.end() && entry->visible == visible && entry->cell.x == x &&
                   entry->cell.y <= row + 1;
                 ++entry) {
                if (entry->end.number() == end.number() ||
                    glm::distance(entry->end.at, end.at) > same_point)
                    continue;
                if (found) return std::nullopt;
                found = entry->end;
            }
        }
        return found;
    }

  private:
    struct Cell {
        double x, y;
    };
    struct Entry {
        bool visible;
        Cell cell;
        End end;

        std::tuple<bool, double, double, std::size_t> order() const {
            return {visible, cell.x, cell.y, end.number()};
        }
    };

    static Cell cell_of(glm::dvec2 at) {
        return {std::floor(at.x / same_point), std::floor(at.y / same_point)};
    }

    std::vector<Entry> entries_;
};

class Joints {
  public:
    explicit Joints(std::vector<VectorPath>& paths)
        : paths_(paths), partners_(2 * paths.size(), none), is_taken_(paths.size(), false) {
        std::vector<End> ends;
        bool any_on_surface = false;
        for (std::uint32_t i = 0; i < paths.size(); ++i)
            if (!paths[i].closed)
                for (const bool at_end : {false, true}) {
                    ends.push_back({point_of(i, at_end).at, i, at_end});
                    any_on_surface |= is_on_surface(ends.back());
                }
        if (!any_on_surface) return;
        const EndsByPlace by_place{paths, ends};
        for (const End& end : ends) {
            if (!is_on_surface(end)) continue;
            const std::optional<End> other = by_place.only_one_beside(end, paths[end.path].visible);
            if (other && go_on(end, *other)) partners_[end.number()] = other->number();
        }
        for (std::size_t i = 0; i < partners_.size(); ++i)
            if (partners_[i] != none && partners_[partners_[i]] != i) partners_[i] = none;
    }

    void join() {
        if (std::ranges::all_of(partners_, [](std::size_t one) { return one == none; })) return;
        std::vector<VectorPath> joined;
        for (const bool of_loops : {false, true})
            for (std::uint32_t i = 0; i < paths_.size(); ++i) {
                if (is_taken_[i]) continue;
                const bool from_start = partners_[2 * std::size_t{i}] == none;
                if (from_start || partners_[2 * std::size_t{i} + 1] == none || of_loops)
                    joined.push_back(take(i, !from_start && !of_loops));
            }
        paths_ = std::move(joined);
    }

  private:
    static constexpr std::size_t none = ~std::size_t{0};

    const VectorPoint& point_of(std::uint32_t path, bool at_end) const {
        return at_end ? paths_[path].points.back() : paths_[path].points.front();
    }

    bool go_on(const End& a, const End& b) const {
        const VectorPath &one = paths_[a.path], &other = paths_[b.path];
        if (!is_on_surface(b) || one.outline != other.outline || one.pen != other.pen) return false;
        return std::abs(angle_between(way_out(a), -way_out(b))) < sharpest;
    }

    bool is_on_surface(const End& end) const {
        const VectorPath& path = paths_[end.path];
        if (path.kind != LineKind::silhouette || path.pieces.empty()) return false;
        return (end.at_end ? path.pieces.back() : path.pieces.front()).face != VectorPiece::none;
    }

    glm::dvec2 way_out(const End& end) const {
        const std::vector<VectorPoint>& points = paths_[end.path].points;
        return end.at_end ? points.back().at - points[points.size() - 2].at
                          : points[0].at - points[1].at;
    }

    /// A path with all that goes on behind it.
    VectorPath take(std::uint32_t first, bool reversed) {
        VectorPath path = part(first, reversed);
        std::size_t onwards = partners_[2 * std::size_t{first} + (reversed ? 0 : 1)];
        while (onwards != none && !is_taken_[onwards / 2]) {
            const auto next = static_cast<std::uint32_t>(onwards / 2);
            const bool backwards = onwards % 2 == 1;
            append_part(path, part(next, backwards));
            onwards = partners_[2 * std::size_t{next} + (backwards ? 0 : 1)];
        }
        if (onwards == 2 * std::size_t{first} + (reversed ? 1 : 0)) {
            path.points.back().at = path.points.front().at;
            path.closed = true;
        }
        return path;
    }

    VectorPath part(std::uint32_t number, bool reversed) {
        is_taken_[number] = true;
        VectorPath path = std::move(paths_[number]);
        if (reversed) reverse(path);
        return path;
    }

    static void append_part(VectorPath& path, VectorPath next) {
        const double length = length_of(path), next_length = length_of(next);
        if (const double whole = length + next_length; whole > 0)
            path.alpha = static_cast<float>(
                (double{path.alpha} * length + double{next.alpha} * next_length) / whole);
        double arc = path.points.back().arc;
        for (std::size_t i = 1; i < next.points.size(); ++i) {
            arc += glm::distance(next.points[i - 1].at, next.points[i].at);
            next.points[i].arc = arc;
        }
        append(path, next);
    }

    std::vector<VectorPath>& paths_;
    std::vector<std::size_t> partners_; ///< per end of a path, the end in which it goes on, or none
    std::vector<bool> is_taken_;        ///< per path
};

} // namespace

void join_smoothly(std::vector<VectorPath>& paths) {
    Joints{paths}.join();
}

} // namespace lineatlas
