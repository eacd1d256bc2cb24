#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/chain.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// A fixed line (always drawn) or a silhouette candidate, before it is chained.
struct Line {
    std::uint32_t p = 0, q = 0;
    std::uint32_t face_a = LA_NO_FACE;
    std::uint32_t face_b = LA_NO_FACE;
    LineKind kind{};
    LineSource source{}; ///< from p to q
};

/// Puts lines into the segment table.
class LineSetBuilder {
  public:
    explicit LineSetBuilder(std::size_t vertices) : edges_at_vertex_(vertices) {}

    /// Says that something else ends at a vertex or goes on from it. Lines there are not alone.
    void touch(std::uint32_t vertex) { ++edges_at_vertex_[vertex]; }
    /// Adds fixed lines as chains, then silhouette candidates.
    void add(const std::vector<glm::vec3>& vertices, const std::vector<Line>& fixed,
             const std::vector<Line>& candidates, float chain_angle);

    LineSet result;

  private:
    void count_vertices(const std::vector<Line>& lines);
    /// Whether nothing else ends or goes on at the ends of a line.
    bool is_alone(const Line& line) const;

    struct PathPlace {
        std::uint32_t before = 0, behind = 0; ///< lines of the path
        std::uint32_t path = 0;
        bool closed = false;
    };
    /// Puts a line into the table as segment i.
    void put(std::size_t i, const Line& line, bool reversed, const PathPlace& place);
    void put_paths(const std::vector<Line>& lines, const Chains& chains);
    void put_candidates(const std::vector<Line>& candidates, std::size_t first);

    std::vector<std::atomic<std::uint32_t>> edges_at_vertex_;
};

} // namespace lineatlas
