#include "core/chain.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "test_meshes.hpp"

namespace lineatlas {
namespace {

constexpr float rounding = 1e-5F; // of cosines

struct Graph {
    std::vector<glm::vec3> vertices;
    std::vector<ChainEdge> edges;

    Chains chains(float angle) const { return chain_edges(vertices, edges, angle); }
    std::uint32_t start(ChainStep step) const {
        return step.reversed ? edges[step.edge].q : edges[step.edge].p;
    }
    std::uint32_t end(ChainStep step) const {
        return step.reversed ? edges[step.edge].p : edges[step.edge].q;
    }
    std::uint32_t far_vertex(std::uint32_t edge, std::uint32_t vertex) const {
        return edges[edge].p == vertex ? edges[edge].q : edges[edge].p;
    }
    /// Cosine of the turn from one edge into another at a common vertex.
    float straightness(std::uint32_t a, std::uint32_t b, std::uint32_t vertex) const {
        const auto inward = [&](std::uint32_t edge) {
            return glm::normalize(vertices[far_vertex(edge, vertex)] - vertices[vertex]);
        };
        return -glm::dot(inward(a), inward(b));
    }
};

/// A polygon in the xy plane, closed or not.
Graph polygon(std::uint32_t corners, bool closed) {
    Graph graph;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const float angle =
            glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(corners);
        graph.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    for (std::uint32_t i = 0; i + (closed ? 0 : 1) < corners; ++i) {
        graph.edges.push_back({i, (i + 1) % corners, 0});
    }
    return graph;
}

/// Edges from the origin towards each of the points.
Graph star(std::vector<glm::vec3> points) {
    Graph graph{.vertices = std::move(points), .edges = {}};
    const auto centre = static_cast<std::uint32_t>(graph.vertices.size());
    for (std::uint32_t i = 0; i < centre; ++i) graph.edges.push_back({centre, i, 0});
    graph.vertices.emplace_back(0, 0, 0);
    return graph;
}

Graph random_graph(test::Random& random, std::uint32_t vertices, std::uint32_t edges) {
    Graph graph;
    for (std::uint32_t i = 0; i < vertices; ++i) graph.vertices.push_back(random.point(1));
    std::set<std::pair<std::uint32_t, std::uint32_t>> known;
    while (graph.edges.size() < edges) {
        const std::uint32_t p = random.below(vertices);
        const std::uint32_t q = random.below(vertices);
        if (p == q || !known.insert(std::minmax(p, q)).second) continue;
        graph.edges.push_back({p, q, random.below(3)});
    }
    return graph;
}

/// Expects all that chains promise, for any graph with at most 64 edges at a vertex.
void expect_sound(const Graph& graph, float angle) {
    const float smallest = std::cos(angle);
    const Chains chains = graph.chains(angle);
    // Per edge and end (0 at p, 1 at q) the next edge, or the edge itself if none follows.
    std::vector<std::array<std::uint32_t, 2>> next(graph.edges.size());
    for (std::uint32_t e = 0; e < next.size(); ++e) next[e] = {e, e};
    std::vector<int> seen(graph.edges.size(), 0);
    const auto join = [&](ChainStep from, ChainStep to) {
        ASSERT_EQ(graph.end(from), graph.start(to)) << "neighbours without a common vertex";
        EXPECT_EQ(graph.edges[from.edge].kind, graph.edges[to.edge].kind);
        EXPECT_GE(graph.straightness(from.edge, to.edge, graph.end(from)), smallest - rounding);
        next[from.edge][from.reversed ? 0 : 1] = to.edge;
        next[to.edge][to.reversed ? 1 : 0] = from.edge;
    };
    for (const Chain& chain : chains) {
        ASSERT_FALSE(chain.steps.empty());
        for (const ChainStep step : chain.steps) ++seen.at(step.edge);
        for (std::size_t i = 0; i + 1 < chain.steps.size(); ++i) {
            join(chain.steps[i], chain.steps[i + 1]);
        }
        if (chain.closed) {
            EXPECT_GE(chain.steps.size(), 3U);
            join(chain.steps.back(), chain.steps.front());
        }
    }
    EXPECT_EQ(std::ranges::count(seen, 1), static_cast<std::ptrdiff_t>(seen.size()))
        << "an edge is missing or stands twice";

    // Two edges that may continue each other are never left apart while each has no next edge or
    // only a less straight one.
    const auto reached = [&](std::uint32_t edge, std::uint32_t vertex) {
        const std::uint32_t other = next[edge][graph.edges[edge].p == vertex ? 0 : 1];
        return other == edge ? -2.0F : graph.straightness(edge, other, vertex);
    };
    for (std::uint32_t a = 0; a < graph.edges.size(); ++a) {
        for (std::uint32_t b = a + 1; b < graph.edges.size(); ++b) {
            if (graph.edges[a].kind != graph.edges[b].kind) continue;
            for (const std::uint32_t vertex : {graph.edges[a].p, graph.edges[a].q}) {
                if (graph.edges[b].p != vertex && graph.edges[b].q != vertex) continue;
                const float here = graph.straightness(a, b, vertex);
                if (here < smallest + rounding) continue;
                EXPECT_GE(std::max(reached(a, vertex), reached(b, vertex)), here - rounding)
                    << "edges " << a << " and " << b << " should have been joined";
            }
        }
    }
}

TEST(Chains, RandomGraphsGiveSoundChains) {
    test::Random random{21};
    for (int round = 0; round < 60; ++round) {
        const std::uint32_t vertices = 6 + random.below(30);
        const Graph graph = random_graph(random, vertices, random.below(vertices * 2));
        for (const float degrees : {20.0F, 65.0F, 120.0F, 179.0F}) {
            expect_sound(graph, glm::radians(degrees));
        }
    }
}

TEST(Chains, NoEdgesNoChains) {
    EXPECT_EQ(Graph{}.chains(1).size(), 0U);
    EXPECT_EQ((Graph{.vertices = {{0, 0, 0}}, .edges = {}}.chains(1).size()), 0U);
}

TEST(Chains, APolygonClosesWhereItsCornersAreBlunt) {
    const Graph octagon = polygon(8, true); // turns by 45 degrees
    ASSERT_EQ(octagon.chains(glm::radians(46.0F)).size(), 1U);
    EXPECT_TRUE(octagon.chains(glm::radians(46.0F))[0].closed);
    EXPECT_EQ(octagon.chains(glm::radians(46.0F))[0].steps.size(), 8U);
    const Chains single = octagon.chains(glm::radians(44.0F));
    EXPECT_EQ(single.size(), 8U);
    for (const Chain& chain : single) EXPECT_FALSE(chain.closed);
}

TEST(Chains, AnOpenPolylineIsOneOpenChainFromEndToEnd) {
    test::Random random{22};
    for (int round = 0; round < 20; ++round) {
        Graph graph = polygon(20, false);
        for (std::size_t i = graph.edges.size() - 1; i > 0; --i) {
            std::swap(graph.edges[i], graph.edges[random.below(static_cast<std::uint32_t>(i + 1))]);
            if (random.coin()) std::swap(graph.edges[i].p, graph.edges[i].q);
        }
        const Chains chains = graph.chains(1);
        ASSERT_EQ(chains.size(), 1U);
        EXPECT_FALSE(chains[0].closed);
        ASSERT_EQ(chains[0].steps.size(), 19U);
        const std::uint32_t first = graph.start(chains[0].steps.front());
        const std::uint32_t last = graph.end(chains[0].steps.back());
        EXPECT_EQ(std::min(first, last), 0U);
        EXPECT_EQ(std::max(first, last), 19U);
    }
}

TEST(Chains, AtACrossingTheStraightestGoOn) {
    // Two lines that cross at a blunt angle; every pairing is allowed.
    const Graph graph = star({{1, 0.3F, 0}, {1, -0.3F, 0}, {-1, 0.3F, 0}, {-1, -0.3F, 0}});
    const Chains chains = graph.chains(glm::radians(179.0F));
    ASSERT_EQ(chains.size(), 2U);
    for (const Chain& chain : chains) {
        ASSERT_EQ(chain.steps.size(), 2U);
        EXPECT_EQ(chain.steps[0].edge + chain.steps[1].edge, 3U);
    }
}

TEST(Chains, KindsStayApart) {
    Graph graph = star({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}});
    graph.edges[1].kind = 1;
    const Chains chains = graph.chains(glm::radians(65.0F));
    EXPECT_EQ(chains.size(), 3U); // the vertical line, and both halves of the other
}

TEST(Chains, NothingGoesOnAtTheApexOfALargeFan) {
    for (const std::uint32_t edges : {64U, 66U}) {
        const Chains chains = star(polygon(edges, true).vertices).chains(1);
        EXPECT_EQ(chains.size(), edges == 64 ? 32U : edges);
    }
}

TEST(Chains, DirectionsOfEdgesDoNotChangeWhatIsJoined) {
    test::Random random{23};
    const auto parts = [](const Chains& chains) {
        std::set<std::set<std::uint32_t>> result;
        for (const Chain& chain : chains) {
            std::set<std::uint32_t> edges;
            for (const ChainStep step : chain.steps) edges.insert(step.edge);
            result.insert(edges);
        }
        return result;
    };
    for (int round = 0; round < 20; ++round) {
        Graph graph = random_graph(random, 30, 60);
        const auto expected = parts(graph.chains(1));
        for (ChainEdge& edge : graph.edges) {
            if (random.coin()) std::swap(edge.p, edge.q);
        }
        EXPECT_EQ(parts(graph.chains(1)), expected);
    }
}

TEST(Chains, TheSameEdgesGiveTheSameChains) {
    test::Random random{24};
    const Graph graph = random_graph(random, 40, 100);
    const Chains first = graph.chains(1.2F);
    const Chains second = graph.chains(1.2F);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_TRUE(std::ranges::equal(first[i].steps, second[i].steps,
                                       [](const ChainStep& a, const ChainStep& b) {
                                           return a.edge == b.edge && a.reversed == b.reversed;
                                       }));
    }
}

TEST(Chains, ScaleDoesNotChangeTheChains) {
    for (const float scale : {1e-15F, 1e15F}) {
        Graph graph = polygon(16, true);
        for (glm::vec3& v : graph.vertices) v *= scale;
        EXPECT_EQ(graph.chains(1).size(), 1U) << scale;
    }
}

} // namespace
} // namespace lineatlas
