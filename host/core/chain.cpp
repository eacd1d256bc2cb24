#include "chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "flags.h"

namespace lineatlas {
namespace {

constexpr std::uint32_t no_end = std::numeric_limits<std::uint32_t>::max();

/// Pairing compares every two edges at a vertex. At a vertex with more edges than this (the apex of
/// a fan) no path continues recognisably, and all paths end.
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
        Groups<std::uint32_t> ends{vertices_.size(), edges_.size(),
                                   [&](std::size_t edge, const auto& add) {
                                       const auto first = static_cast<std::uint32_t>(2 * edge);
                                       for (const std::uint32_t end : {first, opposite(first)})
                                           add(vertex(end), end);
                                   }};
        for_each_piece(vertices_.size(), usual_piece, [&](std::size_t v, std::size_t end) {
            Scratch scratch;
            for (; v < end; ++v) {
                std::ranges::sort(ends[v]);
                link_at_vertex(ends[v], scratch);
            }
        });
    }

    Chains walk() {
        walked_.assign(edges_.size(), false);
        steps_.reserve(edges_.size());
        std::vector<std::size_t> ends; // of chains, in steps_
        const auto follow_to_end = [&](std::uint32_t end) {
            follow(end);
            ends.push_back(steps_.size());
        };
        // Open paths come first, from the ends that nothing continues. The remaining edges form
        // loops.
        for (std::uint32_t end = 0; end < linked_.size(); ++end)
            if (linked_[end] == no_end && !walked_[end / 2]) follow_to_end(end);
        const std::size_t open_count = ends.size();
        for (std::uint32_t edge = 0; edge < edges_.size(); ++edge)
            if (!walked_[edge]) follow_to_end(2 * edge);
        return {std::move(steps_), ends, open_count};
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

    /// Memory for the work at one vertex.
    struct Scratch {
        std::vector<glm::vec3> inward; ///< of its ends
        std::vector<Continuation> candidates;
    };

    void link_at_vertex(std::span<const std::uint32_t> ends, Scratch& scratch) {
        if (ends.size() < 2 || ends.size() > most_edges_paired) return;
        auto& [directions, candidates] = scratch;
        directions.clear();
        candidates.clear();
        for (const std::uint32_t end : ends) directions.push_back(inward(end));
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                const std::uint32_t kind = edges_[ends[i] / 2].kind;
                if (kind != edges_[ends[j] / 2].kind) continue;
                const float cosine = -glm::dot(directions[i], directions[j]);
                // The outline of a cut is one path, even around sharp corners.
                const bool goes_on = cosine >= smallest_cosine_ || kind == LA_KIND_SECTION;
                if (goes_on) candidates.push_back({cosine, ends[i], ends[j]});
            }
        }
        std::stable_sort(
            candidates.begin(), candidates.end(),
            [](const Continuation& a, const Continuation& b) { return a.cosine > b.cosine; });
        for (const Continuation& c : candidates) {
            if (linked_[c.end_a] != no_end || linked_[c.end_b] != no_end) continue;
            linked_[c.end_a] = c.end_b;
            linked_[c.end_b] = c.end_a;
        }
    }

    void follow(std::uint32_t end) {
        while (end != no_end && !walked_[end / 2]) {
            walked_[end / 2] = true;
            steps_.push_back({.edge = end / 2, .reversed = (end & 1U) != 0});
            end = linked_[opposite(end)];
        }
    }

    std::span<const glm::vec3> vertices_;
    std::span<const ChainEdge> edges_;
    float smallest_cosine_;
    std::vector<std::uint32_t> linked_; ///< per edge end, the end that continues it
    std::vector<bool> walked_;
    std::vector<ChainStep> steps_;
};

} // namespace

Chains::Chains(std::vector<ChainStep> steps, const std::vector<std::size_t>& ends,
               std::size_t open_count)
    : steps_(std::move(steps)) {
    chains_.reserve(ends.size());
    std::size_t first = 0;
    for (const std::size_t end : ends) {
        chains_.push_back(
            {std::span{steps_}.subspan(first, end - first), chains_.size() >= open_count});
        first = end;
    }
}

Chains chain_edges(std::span<const glm::vec3> vertices, std::span<const ChainEdge> edges,
                   float chain_angle) {
    Chainer chainer{vertices, edges, chain_angle};
    chainer.link_ends();
    return chainer.walk();
}

} // namespace lineatlas
