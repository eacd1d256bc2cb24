#pragma once

#include <cstdint>
#include <vector>

#include "chain.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// A fixed line (always drawn) or a silhouette candidate, before it is chained.
struct Line {
    std::uint32_t p, q;
    std::uint32_t face_a = LA_NO_FACE;
    std::uint32_t face_b = LA_NO_FACE;
    LineKind kind;
    LineSource source{}; ///< from p to q
};

/// Puts lines into the segment table.
class LineSetBuilder {
  public:
    explicit LineSetBuilder(std::size_t vertices) : edges_at_vertex_(vertices, 0) {}

    /// Something else ends at a vertex, or goes on from it: lines there are not alone.
    void touch(std::uint32_t vertex) { ++edges_at_vertex_[vertex]; }
    /// Fixed lines, chained; then silhouette candidates.
    void add(const std::vector<glm::vec3>& vertices, const std::vector<Line>& fixed,
             const std::vector<Line>& candidates, float chain_angle);

    LineSet result;

  private:
    void count_vertices(const std::vector<Line>& lines);
    void append(const Line& line, bool reversed, std::uint32_t from_start, std::uint32_t to_end,
                bool closed);
    void append_paths(const std::vector<Line>& lines, const std::vector<Chain>& chains);
    void append_candidates(const std::vector<Line>& candidates);

    std::vector<std::uint32_t> edges_at_vertex_;
};

} // namespace lineatlas
