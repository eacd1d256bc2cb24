#include "chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "flags.h"

namespace lineatlas {
namespace {

constexpr std::uint32_t no_end = std::numeric_limits<std::uint32_t>::max();

/// Pairing compares every two edges at a vertex; above this many (the apex of a fan) nothing
/// continues recognisably, and paths end there.
constexpr std::size_t most_edges_paired = 64;

// An edge end is 2 * edge + (0 at p, 1 at q).
std::uint32_t opposite(std::uint32_t end) {
    return end ^ 1U;
}

struct Continuation {
    float cosine; ///< of the turn: 1 is straight on
    std::uint32_t end_a, end_b;
};

class Chainer {
  public:
    Chainer(std::span<const glm::vec3> vertices, std::span<const ChainEdge> edges,
            float chain_angle)
        : vertices_(vertices), edges_(edges), smallest_cosine_(std::cos(chain_angle)),
          linked_(edges.size() * 2, no_end) {}

    void link_ends() {
        std::vector<std::uint32_t> first(vertices_.size() + 1, 0);
        for (const ChainEdge& edge : edges_) {
            ++first[edge.p + 1];
            ++first[edge.q + 1];
        }
        for (std::size_t v = 0; v < vertices_.size(); ++v) first[v + 1] += first[v];
        std::vector<std::uint32_t> ends(edges_.size() * 2);
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (std::uint32_t end = 0; end < ends.size(); ++end) ends[next[vertex(end)]++] = end;
        for (std::size_t v = 0; v < vertices_.size(); ++v) {
            link_at_vertex({ends.data() + first[v], first[v + 1] - first[v]});
        }
    }

    std::vector<Chain> walk() {
        std::vector<Chain> chains;
        walked_.assign(edges_.size(), false);
        // Open paths first, from the ends that nothing continues; what is left are loops.
        for (std::uint32_t end = 0; end < linked_.size(); ++end) {
            if (linked_[end] == no_end && !walked_[end / 2]) chains.push_back(follow(end, false));
        }
        for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
            if (!walked_[edge]) chains.push_back(follow(2 * edge, true));
        }
        return chains;
    }

  private:
    std::uint32_t vertex(std::uint32_t end) const {
        const ChainEdge& edge = edges_[end / 2];
        return (end & 1U) != 0 ? edge.q : edge.p;
    }

    /// Unit direction from the end into its edge.
    glm::vec3 inward(std::uint32_t end) const {
        const glm::vec3 d = vertices_[vertex(opposite(end))] - vertices_[vertex(end)];
        const float length = glm::length(d);
        return length > 0 ? d / length : glm::vec3{0};
    }

    void link_at_vertex(std::span<const std::uint32_t> ends) {
        if (ends.size() < 2 || ends.size() > most_edges_paired) return;
        candidates_.clear();
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                const std::uint32_t kind = edges_[ends[i] / 2].kind;
                if (kind != edges_[ends[j] / 2].kind) continue;
                const float cosine = -glm::dot(inward(ends[i]), inward(ends[j]));
                // The outline of a cut is one way, whatever corners it has.
                const bool goes_on = cosine >= smallest_cosine_ || kind == LA_KIND_SECTION;
                if (goes_on) candidates_.push_back({cosine, ends[i], ends[j]});
            }
        }
        std::stable_sort(
            candidates_.begin(), candidates_.end(),
            [](const Continuation& a, const Continuation& b) { return a.cosine > b.cosine; });
        for (const Continuation& c : candidates_) {
            if (linked_[c.end_a] != no_end || linked_[c.end_b] != no_end) continue;
            linked_[c.end_a] = c.end_b;
            linked_[c.end_b] = c.end_a;
        }
    }

    Chain follow(std::uint32_t end, bool closed) {
        Chain chain{.steps = {}, .closed = closed};
        while (end != no_end && !walked_[end / 2]) {
            walked_[end / 2] = true;
            chain.steps.push_back({.edge = end / 2, .reversed = (end & 1U) != 0});
            end = linked_[opposite(end)];
        }
        return chain;
    }

    std::span<const glm::vec3> vertices_;
    std::span<const ChainEdge> edges_;
    float smallest_cosine_;
    std::vector<std::uint32_t> linked_; ///< per edge end, the end that continues it
    std::vector<bool> walked_;
    std::vector<Continuation> candidates_;
};

} // namespace

std::vector<Chain> chain_edges(std::span<const glm::vec3> vertices,
                               std::span<const ChainEdge> edges, float chain_angle) {
    Chainer chainer{vertices, edges, chain_angle};
    chainer.link_ends();
    return chainer.walk();
}

} // namespace lineatlas
