#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>

#include "core/pair_key.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The file's edges by the places of their ends: several positions of the mesh may be at one place.
class EdgesByPlace {
  public:
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< no edge

    explicit EdgesByPlace(const Mesh& mesh) : mesh_(mesh) {
        for (std::uint32_t i = 0; i < mesh.known_edges.size(); ++i) {
            const KnownEdge& edge = mesh.known_edges[i];
            const std::uint32_t from = places_.emplace(place(edge.from), edge.from).first->second;
            const std::uint32_t to = places_.emplace(place(edge.to), edge.to).first->second;
            pieces_.emplace(pair_key(from, to), i);
        }
    }

    /// The number of the edge that a segment is a part of, or `none`.
    std::uint32_t edge_of(const LineSource& source) const {
        const std::uint32_t piece = piece_of(source);
        return piece == none ? none : mesh_.known_edges[piece].edge;
    }
    /// Which of Mesh::known_edges that is, or `none`.
    std::uint32_t piece_of(const LineSource& source) const {
        if (pieces_.empty() || source.from >= mesh_.positions.size() ||
            source.to >= mesh_.positions.size())
            return none;
        const auto from = places_.find(place(source.from)), to = places_.find(place(source.to));
        if (from == places_.end() || to == places_.end()) return none;
        const auto found = pieces_.find(pair_key(from->second, to->second));
        return found == pieces_.end() ? none : found->second;
    }

  private:
    using Place = std::array<float, 3>;
    struct Hash {
        std::size_t operator()(const Place& at) const {
            std::size_t result = 0;
            for (const float x : at) result = result * 0x9E3779B97F4A7C15U + std::hash<float>{}(x);
            return result;
        }
    };

    Place place(std::uint32_t position) const {
        const glm::vec3 at = mesh_.positions[position];
        return {at.x, at.y, at.z};
    }

    const Mesh& mesh_;
    std::unordered_map<Place, std::uint32_t, Hash> places_;
    std::unordered_map<std::uint64_t, std::uint32_t> pieces_;
};

} // namespace lineatlas
