#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas {

/// An edge to be chained. Only edges of equal `kind` go into one path.
struct ChainEdge {
    std::uint32_t p, q;
    std::uint32_t kind;
};

/// One step along a path: an edge, walked from p to q or backwards.
struct ChainStep {
    std::uint32_t edge;
    bool reversed;
};

struct Chain {
    std::span<const ChainStep> steps; ///< into those of its Chains
    bool closed = false;              ///< the last step continues in the first
};

/// All paths, whose steps stand one after the other.
class Chains {
  public:
    Chains(std::vector<ChainStep> steps, const std::vector<std::size_t>& ends,
           std::size_t open_count);
    Chains(Chains&&) = default;
    Chains& operator=(Chains&&) = default;

    std::size_t size() const { return chains_.size(); }
    const Chain& operator[](std::size_t i) const { return chains_[i]; }
    auto begin() const { return chains_.begin(); }
    auto end() const { return chains_.end(); }

  private:
    std::vector<ChainStep> steps_;
    std::vector<Chain> chains_;
};

/// Joins edges into paths. At each vertex the straightest continuations are paired first; a path
/// goes on where it turns by no more than `chain_angle` (radians). Every edge is in exactly one
/// path. The result depends on the order of `edges` alone.
Chains chain_edges(std::span<const glm::vec3> vertices, std::span<const ChainEdge> edges,
                   float chain_angle);

} // namespace lineatlas
