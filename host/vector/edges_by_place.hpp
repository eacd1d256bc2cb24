#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/equal_positions.hpp"
#include "base/vertex_pairs.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The file's edges by the places of their ends: several positions of the mesh may be at one place.
class EdgesByPlace {
  public:
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< no edge

    explicit EdgesByPlace(const Mesh& mesh) : mesh_(mesh) {
        if (mesh.known_edges.empty()) return;
        place_of_ = equal_positions(mesh.positions);
        pieces_.emplace(place_of_.size(), mesh.known_edges.size(), [&](std::size_t i) {
            const KnownEdge& edge = mesh.known_edges[i];
            return std::optional{glm::uvec2{place_of_[edge.from], place_of_[edge.to]}};
        });
    }

    /// The number of the edge that a segment is a part of, or `none`.
    std::uint32_t edge_of(const LineSource& source) const {
        const std::uint32_t piece = piece_of(source);
        return piece == none ? none : mesh_.known_edges[piece].edge;
    }
    /// Index into Mesh::known_edges of the edge that a segment is a part of, or `none`.
    std::uint32_t piece_of(const LineSource& source) const {
        if (!pieces_ || source.from >= place_of_.size() || source.to >= place_of_.size())
            return none;
        const auto found = pieces_->between(place_of_[source.from], place_of_[source.to]);
        return found.empty() ? none : found.front().index;
    }

  private:
    const Mesh& mesh_;
    std::vector<std::uint32_t> place_of_; ///< per position the first one at its place
    std::optional<VertexPairs> pieces_;   ///< of Mesh::known_edges
};

} // namespace lineatlas
