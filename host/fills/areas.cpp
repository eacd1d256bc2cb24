#include "areas.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"

namespace lineatlas {
namespace {

class Joined {
  public:
    Joined(const PlanarMap& map, std::span<const std::uint32_t> kinds)
        : map_(map), kinds_(kinds), borders_at_(map.places().size(), 0),
          kept_(map.places().size(), false) {
        for (std::uint32_t h = 0; h < map.half_edge_count(); ++h)
            if (is_border(h)) ++borders_at_[map.start_of(h)];
    }

    /// Decides which places stay.
    void straighten(double tolerance) {
        for (std::size_t place = 0; place < kept_.size(); ++place)
            kept_[place] = borders_at_[place] != 0 && borders_at_[place] != 2;
        std::vector<bool> done(map_.half_edge_count(), false);
        const auto straighten_from = [&](std::uint32_t h) {
            ask_between_pieces();
            const std::vector<std::uint32_t> chain = chain_from(h, done);
            if (chain.front() == chain.back() && borders_at_[chain.front()] == 2)
                return straighten_ring(chain, tolerance);
            straighten_chain(chain, tolerance);
        };
        for (const bool rings : {false, true}) {
            for (std::uint32_t h = 0; h < map_.half_edge_count(); ++h)
                if (is_border(h) && !done[h] && (rings || kept_[map_.start_of(h)]))
                    straighten_from(h);
        }
    }

    std::vector<Area> areas() const {
        std::map<std::uint32_t, Area> by_kind;
        std::vector<bool> done(map_.half_edge_count(), false);
        for (std::uint32_t h = 0; h < map_.half_edge_count(); ++h) {
            const std::uint32_t kind = kind_of(h);
            if (done[h] || kind == no_area || !is_border(h)) continue;
            std::vector<GridPlace> ring = ring_from(h, done);
            if (ring.size() < 3) continue; // thinner than the tolerance
            Area& area = by_kind.try_emplace(kind, Area{kind, {}}).first->second;
            area.rings.push_back(std::move(ring));
        }
        std::vector<Area> areas;
        for (auto& [kind, area] : by_kind) areas.push_back(std::move(area));
        return areas;
    }

  private:
    std::uint32_t kind_of(std::uint32_t half_edge) const {
        const std::uint32_t face = map_.face(half_edge);
        return face == PlanarMap::outside ? no_area : kinds_[face];
    }

    bool is_border(std::uint32_t half_edge) const {
        return kind_of(half_edge) != kind_of(half_edge ^ 1U);
    }

    /// The border that goes on around the same area.
    std::uint32_t next_border(std::uint32_t half_edge) const {
        std::uint32_t next = map_.next(half_edge);
        while (!is_border(next)) next = map_.next(next ^ 1U);
        return next;
    }

    /// The places of a border up to where others meet it, or all around.
    std::vector<std::uint32_t> chain_from(std::uint32_t first, std::vector<bool>& done) const {
        std::vector<std::uint32_t> chain{map_.start_of(first)};
        std::uint32_t h = first;
        while (true) {
            done[h] = done[h ^ 1U] = true;
            chain.push_back(map_.end_of(h));
            if (chain.back() == chain.front() || borders_at_[chain.back()] != 2) return chain;
            h = next_border(h);
        }
    }

    double far_from(std::uint32_t place, std::uint32_t from, std::uint32_t to) const {
        const glm::dvec2 a{map_.places()[from]};
        const glm::dvec2 at = glm::dvec2{map_.places()[place]} - a;
        const glm::dvec2 way = glm::dvec2{map_.places()[to]} - a;
        const double length = glm::dot(way, way);
        const double share = length > 0 ? std::clamp(glm::dot(at, way) / length, 0.0, 1.0) : 0;
        return glm::distance(at, share * way);
    }

    /// The place of a chain that is farthest from the line between its ends, and its distance.
    std::pair<std::size_t, double> farthest(std::span<const std::uint32_t> chain) const {
        std::pair<std::size_t, double> result{0, -1};
        for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
            const double far = far_from(chain[i], chain.front(), chain.back());
            if (far > result.second) result = {i, far};
        }
        return result;
    }

    /// Keeps places as Douglas and Peucker (1973) do.
    void straighten_chain(std::span<const std::uint32_t> chain, double tolerance) {
        std::vector<std::span<const std::uint32_t>> open{chain};
        while (!open.empty()) {
            const std::span<const std::uint32_t> part = open.back();
            open.pop_back();
            const auto [middle, far] = farthest(part);
            if (!(far > tolerance)) continue;
            kept_[part[middle]] = true;
            open.push_back(part.subspan(middle));
            open.push_back(part.first(middle + 1));
        }
    }

    /// The same for a ring that no other border meets.
    void straighten_ring(std::span<const std::uint32_t> ring, double tolerance) {
        const std::size_t middle = farthest(ring).first;
        kept_[ring.front()] = kept_[ring[middle]] = true;
        straighten_chain(ring.first(middle + 1), tolerance);
        straighten_chain(ring.subspan(middle), tolerance);
    }

    std::vector<GridPlace> ring_from(std::uint32_t first, std::vector<bool>& done) const {
        std::vector<GridPlace> ring;
        for (std::uint32_t h = first; !done[h]; h = next_border(h)) {
            done[h] = true;
            if (kept_[map_.start_of(h)]) ring.push_back(map_.start(h));
        }
        return ring;
    }

    const PlanarMap& map_;
    std::span<const std::uint32_t> kinds_;
    std::vector<std::uint32_t> borders_at_; ///< per place
    std::vector<bool> kept_;                ///< per place
};

} // namespace

std::vector<Area> join_faces(const PlanarMap& map, std::span<const std::uint32_t> kinds,
                             double tolerance) {
    Joined joined{map, kinds};
    joined.straighten(tolerance);
    return joined.areas();
}

} // namespace lineatlas
