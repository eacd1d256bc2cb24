#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>

#include <glm/vec3.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// Edges of a file that run neither straight nor along a circle or an ellipse (Mesh::edge_curves).
/// Their points lie on the curve itself. Between two points the curve is approximated by a cubic,
/// whose directions at both come from polynomials through the neighbouring points.
class SplineEdges {
  public:
    explicit SplineEdges(const Mesh& mesh);

    /// The curve over a chord, by the share of the chord.
    struct Span {
        glm::dvec3 from, to; ///< the chord's ends
        glm::dvec3 out, in;  ///< the curve's derivatives at them
        double turn;         ///< angle between these

        glm::dvec3 at(double share) const;
        /// The share of the place on the chord next to a point; below 0 or above 1 beyond the
        /// chord's ends.
        double share_of(glm::dvec3 point) const;
    };
    /// The curve of one of Mesh::known_edges, by its index; null if the edge is its chord.
    const Span* span(std::uint32_t piece) const;

    bool empty() const { return spans_.empty(); }

  private:
    /// Adds consecutive pieces of one edge, each of which begins where the one before ends.
    void add_run(const Mesh& mesh, std::uint32_t first, std::uint32_t count);
    void add_smooth(std::span<const glm::dvec3> points, std::uint32_t first);

    std::unordered_map<std::uint32_t, Span> spans_;
};

} // namespace lineatlas
