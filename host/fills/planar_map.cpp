#include "planar_map.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

#include "base/parallel.hpp"
#include "vector/segment_grid.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Half-edges by the place where they start.
struct Starts {
    std::vector<std::uint32_t> first; ///< per place, and one behind the last, into `list`
    std::vector<std::uint32_t> list;
};

Starts starts_of(const PlanarMap& map, std::size_t places, std::uint32_t half_edges) {
    Starts starts{std::vector<std::uint32_t>(places + 1, 0),
                  std::vector<std::uint32_t>(half_edges)};
    for (std::uint32_t h = 0; h < half_edges; ++h) ++starts.first[map.start_of(h) + 1];
    std::partial_sum(starts.first.begin(), starts.first.end(), starts.first.begin());
    std::vector<std::uint32_t> at = starts.first;
    for (std::uint32_t h = 0; h < half_edges; ++h) starts.list[at[map.start_of(h)]++] = h;
    return starts;
}

/// Whether a direction points below the x axis, or along it to the left.
bool is_lower(GridPlace way) {
    return way.y < 0 || (way.y == 0 && way.x < 0);
}

bool turns_before(GridPlace a, GridPlace b) {
    if (is_lower(a) != is_lower(b)) return is_lower(b);
    return a.x * b.y - a.y * b.x > 0;
}

/// Where a half-edge that goes past `y`, or begins or ends there, is at that height.
double x_at(GridPlace a, GridPlace b, std::int64_t y) {
    if (a.y == y) return static_cast<double>(a.x);
    if (b.y == y) return static_cast<double>(b.x);
    const auto share = static_cast<double>(y - a.y) / static_cast<double>(b.y - a.y);
    return static_cast<double>(a.x) + share * static_cast<double>(b.x - a.x);
}

/// By how much x changes as y grows by 1.
double slope(GridPlace a, GridPlace b) {
    return static_cast<double>(b.x - a.x) / static_cast<double>(b.y - a.y);
}

} // namespace

PlanarMap::PlanarMap(SnappedEdges edges, glm::ivec2 size, const GridScale& scale)
    : edges_(std::move(edges)), next_(2 * edges_.edges.size()) {
    order_around_places();
    find_loops();
    find_components();
    find_faces(size, scale);
}

void PlanarMap::order_around_places() {
    Starts starts = starts_of(*this, places().size(), half_edge_count());
    for (std::size_t place = 0; place < places().size(); ++place) {
        if (place % usual_piece == 0) ask_between_pieces();
        const auto first = starts.list.begin() + starts.first[place];
        const auto last = starts.list.begin() + starts.first[place + 1];
        std::sort(first, last, [&](std::uint32_t a, std::uint32_t b) {
            return turns_before(end(a) - start(a), end(b) - start(b));
        });
        // A way around a face that comes in along one half-edge goes out along the one before it.
        for (auto out = first; out != last; ++out)
            next_[*out ^ 1U] = out == first ? *(last - 1) : *(out - 1);
    }
}

void PlanarMap::find_loops() {
    loop_.assign(next_.size(), none);
    for (std::uint32_t first = 0; first < next_.size(); ++first) {
        if (loop_[first] != none) continue;
        const auto loop = static_cast<std::uint32_t>(loop_start_.size());
        std::uint64_t area = 0; // twice; single terms may be too large, but not the sum
        std::uint32_t leftmost = first;
        for (std::uint32_t h = first; loop_[h] == none; h = next_[h]) {
            loop_[h] = loop;
            const GridPlace a = start(h), b = end(h);
            area += static_cast<std::uint64_t>(a.x) * static_cast<std::uint64_t>(b.y) -
                    static_cast<std::uint64_t>(a.y) * static_cast<std::uint64_t>(b.x);
            leftmost = std::min(leftmost, h, [&](std::uint32_t one, std::uint32_t other) {
                return start_of(one) < start_of(other);
            });
        }
        loop_start_.push_back(leftmost);
        is_inner_.push_back(static_cast<std::int64_t>(area) > 0);
    }
}

void PlanarMap::find_components() {
    component_.resize(places().size());
    std::iota(component_.begin(), component_.end(), 0U);
    const auto root = [&](std::uint32_t place) {
        while (component_[place] != place)
            place = component_[place] = component_[component_[place]];
        return place;
    };
    for (const SnappedEdges::Edge& edge : edges_.edges) {
        const std::uint32_t a = root(edge.a), b = root(edge.b);
        component_[std::max(a, b)] = std::min(a, b);
    }
    for (std::uint32_t place = 0; place < component_.size(); ++place)
        component_[place] = root(place);
}

void PlanarMap::find_faces(glm::ivec2 size, const GridScale& scale) {
    face_of_loop_.assign(loop_start_.size(), outside);
    for (std::uint32_t loop = 0; loop < loop_start_.size(); ++loop)
        if (is_inner_[loop]) face_of_loop_[loop] = face_count_++;
    SegmentGrid grid{glm::dvec2{size}};
    for (std::uint32_t i = 0; i < edges_.edges.size(); ++i)
        grid.insert(scale.pixels(start(2 * i)), scale.pixels(end(2 * i)), i);

    /// The half-edge nearest to the left of a place with that place on its left side.
    const auto left_of = [&](std::uint32_t half_edge) -> std::optional<std::uint32_t> {
        const GridPlace at = start(half_edge);
        std::optional<std::uint32_t> nearest;
        std::tuple<double, double> best;
        for (const std::uint32_t edge :
             grid.near(scale.pixels({0, at.y}), scale.pixels(at), 2 / scale.per_pixel)) {
            std::uint32_t down = 2 * edge;
            if (start(down).y < end(down).y) down ^= 1U;
            const GridPlace top = start(down), bottom = end(down);
            if (!(bottom.y <= at.y && at.y < top.y)) continue;
            if (component_of(down) == component_of(half_edge)) continue;
            const std::tuple place{x_at(bottom, top, at.y), slope(bottom, top)};
            if (!(std::get<0>(place) < static_cast<double>(at.x))) continue;
            if (nearest && !(best < place)) continue;
            nearest = down;
            best = place;
        }
        return nearest;
    };
    std::vector<std::uint32_t> holes;
    for (std::uint32_t loop = 0; loop < loop_start_.size(); ++loop)
        if (!is_inner_[loop]) holes.push_back(loop);
    // From left to right: what stands to the left of a hole has its face by then.
    std::ranges::sort(holes, {}, [&](std::uint32_t loop) { return start_of(loop_start_[loop]); });
    for (const std::uint32_t hole : holes) {
        ask_between_pieces();
        if (const auto beside = left_of(loop_start_[hole]))
            face_of_loop_[hole] = face_of_loop_[loop_[*beside]];
    }
}

} // namespace lineatlas
