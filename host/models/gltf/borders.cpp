#include "borders.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>
#include <utility>

#include <glm/geometric.hpp>

namespace lineatlas::gltf {
namespace {

struct Hash {
    template <class Vector>
    std::size_t operator()(const Vector& v) const {
        std::size_t result = 0;
        for (int axis = 0; axis < 3; ++axis)
            result =
                (result ^ std::hash<typename Vector::value_type>{}(v[axis])) * 0x9E3779B97F4A7C15U;
        return result ^ result >> 32U;
    }
};

bool is_finite(const glm::dvec3& place) {
    return std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
}

/// The most that rounding moves a position: half a step in each of three directions.
double reach_of(const Primitive& primitive) {
    return 0.5 * std::numbers::sqrt3 * primitive.step;
}

/// The places of corners at edges with a single triangle, each once.
std::vector<glm::dvec3> border_of(const Primitive& primitive) {
    std::unordered_map<glm::dvec3, std::uint32_t, Hash> ids;
    std::vector<glm::dvec3> places;
    std::vector<std::uint32_t> id_of;
    id_of.reserve(primitive.positions.size());
    for (const glm::dvec3& place : primitive.positions) {
        const auto [entry, fresh] =
            ids.try_emplace(place, static_cast<std::uint32_t>(places.size()));
        if (fresh) places.push_back(place);
        id_of.push_back(entry->second);
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(3 * primitive.triangles.size());
    for (const auto& corners : primitive.triangles) {
        for (std::size_t i = 0; i < 3; ++i)
            edges.push_back(std::minmax({id_of[corners[i]], id_of[corners[(i + 1) % 3]]}));
    }
    std::ranges::sort(edges);
    std::vector<bool> on_border(places.size());
    for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
        for (end = first; end < edges.size() && edges[end] == edges[first];) ++end;
        if (end - first == 1) on_border[edges[first].first] = on_border[edges[first].second] = true;
    }
    std::vector<glm::dvec3> border;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (on_border[i] && is_finite(places[i])) border.push_back(places[i]);
    return border;
}

/// Corners that others may be moved to, in cells as large as the largest possible move.
class Corners {
  public:
    explicit Corners(double cell) : cell_{cell} {}

    void add(const glm::dvec3& place, double reach) {
        cells_.emplace(cell_of(place), Corner{place, reach});
    }

    struct Corner {
        glm::dvec3 place;
        double reach;
        bool taken = false; ///< by a corner of the current primitive
    };

    /// The nearest corner that may be the same and is not taken, or null.
    Corner* nearest(const glm::dvec3& place, double reach) {
        Corner* best = nullptr;
        double distance = 0;
        const Cell middle = cell_of(place);
        for (int i = 0; i < 27; ++i) {
            const auto [first, last] =
                cells_.equal_range(middle + Cell{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1});
            for (auto entry = first; entry != last; ++entry) {
                Corner& corner = entry->second;
                const double away = glm::distance(corner.place, place);
                const double rounding = 1e-6 * (reach + corner.reach);
                if (corner.taken || away > reach + corner.reach + rounding) continue;
                if (best != nullptr && away >= distance) continue;
                best = &corner;
                distance = away;
            }
        }
        return best;
    }
    void give_all_back() {
        for (auto& [cell, corner] : cells_) corner.taken = false;
    }

  private:
    using Cell = glm::vec<3, std::int64_t>;
    Cell cell_of(const glm::dvec3& place) const {
        constexpr double far = 1e18; // the range of whole numbers ends a little beyond
        return Cell{glm::floor(glm::clamp(place / cell_, -far, far))};
    }

    double cell_;
    std::unordered_multimap<Cell, Corner, Hash> cells_;
};

} // namespace

void join_borders(std::vector<Primitive>& primitives) {
    double reach = 0;
    for (const Primitive& primitive : primitives) reach = std::max(reach, reach_of(primitive));
    if (reach == 0 || primitives.size() < 2) return;
    Corners corners{2.01 * reach};
    for (Primitive& primitive : primitives) {
        const double own_reach = reach_of(primitive);
        std::unordered_map<glm::dvec3, glm::dvec3, Hash> moved;
        std::vector<glm::dvec3> stay;
        for (const glm::dvec3& place : border_of(primitive)) {
            if (auto* corner = corners.nearest(place, own_reach)) {
                corner->taken = true;
                if (corner->place != place) moved.emplace(place, corner->place);
            } else {
                stay.push_back(place);
            }
        }
        for (glm::dvec3& position : primitive.positions)
            if (const auto found = moved.find(position); found != moved.end())
                position = found->second;
        corners.give_all_back();
        for (const glm::dvec3& place : stay) corners.add(place, own_reach);
    }
}

} // namespace lineatlas::gltf
