#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "snapped_edges.hpp"

namespace lineatlas {

/// The faces that edges divide the plane into. Every edge is two half-edges, i and i ^ 1, each with
/// the face to its left (from x towards y) beside it.
class PlanarMap {
  public:
    static constexpr std::uint32_t outside = 0xFFFFFFFF; ///< the face around all others

    /// `size`: of the picture that the edges lie in.
    PlanarMap(SnappedEdges edges, glm::ivec2 size, const GridScale& scale);

    std::uint32_t half_edge_count() const { return static_cast<std::uint32_t>(next_.size()); }
    std::uint32_t face_count() const { return face_count_; }
    const std::vector<GridPlace>& places() const { return edges_.places; }

    std::uint32_t start_of(std::uint32_t half_edge) const {
        const SnappedEdges::Edge& edge = edges_.edges[half_edge / 2];
        return half_edge % 2 == 0 ? edge.a : edge.b;
    }
    std::uint32_t end_of(std::uint32_t half_edge) const { return start_of(half_edge ^ 1U); }
    GridPlace start(std::uint32_t half_edge) const { return places()[start_of(half_edge)]; }
    GridPlace end(std::uint32_t half_edge) const { return places()[end_of(half_edge)]; }
    /// The half-edge that goes on around the same face.
    std::uint32_t next(std::uint32_t half_edge) const { return next_[half_edge]; }
    std::uint32_t face(std::uint32_t half_edge) const { return face_of_loop_[loop_[half_edge]]; }

  private:
    void order_around_places();
    void find_loops();
    void find_faces(glm::ivec2 size, const GridScale& scale);
    void find_components();
    std::uint32_t component_of(std::uint32_t half_edge) const {
        return component_[start_of(half_edge)];
    }

    SnappedEdges edges_;
    std::vector<std::uint32_t> next_;
    std::vector<std::uint32_t> loop_;       ///< per half-edge
    std::vector<std::uint32_t> loop_start_; ///< per loop its half-edge from the leftmost place
    std::vector<bool> is_inner_;            ///< per loop whether it goes round its face
    std::vector<std::uint32_t> component_;  ///< per place the least of those connected with it
    std::vector<std::uint32_t> face_of_loop_;
    std::uint32_t face_count_ = 0;
};

} // namespace lineatlas
