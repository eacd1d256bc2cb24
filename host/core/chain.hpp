#pragma once

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
    std::vector<ChainStep> steps;
    bool closed = false; ///< the last step continues in the first
};

/// Joins edges into paths. At each vertex the straightest continuations are paired first; a path
/// goes on where it turns by no more than `chain_angle` (radians). Every edge is in exactly one
/// path. The result depends on the order of `edges` alone.
std::vector<Chain> chain_edges(std::span<const glm::vec3> vertices,
                               std::span<const ChainEdge> edges, float chain_angle);

} // namespace lineatlas
