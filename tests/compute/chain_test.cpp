// chain: orders silhouettes as they follow each other, in graphs with known chains.

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <random>

#include "compute/stages/silhouette_chains.hpp"
#include "stage_test.hpp"
#include "visibility/line_tables.hpp"

namespace lineatlas::test {
namespace {

/// Edges between vertices, some of which are silhouettes.
struct Graph {
    std::vector<glm::vec3> vertices;
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::vector<bool> is_silhouette{}; ///< per edge; empty: all are
};

/// A chain: its edges in order. An edge that runs against the chain is -1 - edge.
struct FoundChain {
    std::vector<int> edges;
    bool closed;
    bool operator==(const FoundChain&) const = default;
};

std::ostream& operator<<(std::ostream& out, const FoundChain& chain) {
    for (const int edge : chain.edges) out << edge << ' ';
    return out << (chain.closed ? "closed" : "open");
}

Segment segment(std::array<std::uint32_t, 2> ends, std::uint32_t face_b, std::uint32_t path,
                std::uint32_t kind) {
    return {.p = ends[0],
            .q = ends[1],
            .face_a = 0,
            .face_b = face_b,
            .from_start = 0,
            .to_end = 0,
            .path = path,
            .tag = kind};
}

class ChainStage : public StageTest {
  protected:
    /// The chains of a graph in a view along z. In the table the edges are candidates after a line
    /// that is always drawn.
    std::vector<FoundChain> chains(const Graph& graph) {
        constexpr std::uint32_t first_path = 100;
        std::vector<Segment> segments{segment({0, 1}, 1, 0, LA_KIND_CREASE)};
        for (std::uint32_t i = 0; i < graph.edges.size(); ++i) {
            const bool shown = graph.is_silhouette.empty() || graph.is_silhouette[i];
            segments.push_back(
                segment(graph.edges[i], shown ? 1 : 0, first_path + i, LA_KIND_SILHOUETTE));
        }
        const std::vector<LineTables::Chunk> chunks = upload_segments(device(), segments);
        EXPECT_EQ(chunks[0].candidate_count, graph.edges.size());
        const auto vertices = put(graph.vertices);
        const auto front = put(std::vector<std::uint8_t>{1, 0}); // face 0 is seen, 1 isn't
        const auto at_once = [](const char*, const auto& action) { action(); };
        const compute::SegmentTable table{.vertices = *vertices,
                                          .triangles = *vertices,
                                          .segments = *chunks[0].segments,
                                          .triangle_count = 2,
                                          .segment_count = chunks[0].range.count,
                                          .candidates = chunks[0].candidates()};
        chains_.follow(before_.get()); // none at first
        const auto find = [&] {
            return chains_.find(table, *front, {{0, 0, 1, 0}, true}, at_once);
        };
        std::optional<compute::SegmentTable> found;
        found.emplace(find());
        device().finish();
        if (!chains_.settle()) {
            ++too_many_;
            found.emplace(find());
            device().finish();
            EXPECT_TRUE(chains_.settle());
        }
        auto ordered = get<Segment>(found->segments, found->segment_count);
        for (; ordered.size() > 1 + chains_.count(); ordered.pop_back())
            EXPECT_EQ(ordered.back().p, ordered.back().q) << "it fills the room";
        EXPECT_EQ(ordered[0].tag, LA_KIND_CREASE);
        const std::vector<std::uint32_t> origins = chains_.read_origins();
        if (follows_) {
            if (!before_) before_ = put(std::vector<std::uint32_t>(graph.edges.size()));
            device().copy(chains_.order(table, *before_).positions, *before_,
                          graph.edges.size() * sizeof(std::uint32_t));
        }
        EXPECT_EQ(origins.size() + 1, ordered.size());
        std::vector<FoundChain> result;
        for (std::size_t i = 0; i < origins.size(); ++i) {
            const Segment& one = ordered[i + 1];
            const auto edge = static_cast<int>((origins[i] - 1) >> 1U);
            const bool reversed = ((origins[i] - 1) & 1U) != 0;
            const auto [p, q] = graph.edges[static_cast<std::size_t>(edge)];
            EXPECT_EQ(one.p, reversed ? q : p);
            EXPECT_EQ(one.q, reversed ? p : q);
            if (one.from_start == 0) result.push_back({{}, (one.tag & LA_TAG_CLOSED) != 0});
            EXPECT_EQ(one.from_start, result.back().edges.size());
            if (one.from_start > 0) {
                EXPECT_EQ(ordered[i].q, one.p);
                EXPECT_EQ(ordered[i].to_end, one.to_end + 1);
                EXPECT_EQ(ordered[i].path, one.path);
                EXPECT_EQ(ordered[i].tag, one.tag);
            }
            result.back().edges.push_back(reversed ? -1 - edge : edge);
            if (one.to_end > 0) continue;
            if (result.back().closed) {
                EXPECT_EQ(one.q, ordered[i + 1 - one.from_start].p);
            }
            const auto number = [](int value) { return value < 0 ? -1 - value : value; };
            const int least = number(*std::ranges::min_element(result.back().edges, {}, number));
            if (!follows_) {
                EXPECT_EQ(one.path, first_path + static_cast<std::uint32_t>(least));
            }
        }
        return result;
    }

    /// From here on each graph is a frame after that of the graph before.
    void follow() { follows_ = true; }
    /// From here on the host guesses how many silhouettes there are.
    void guess() { chains_.guess(true); }
    int too_many() const { return too_many_; } ///< graphs with more than it guessed

  private:
    bool follows_ = false;
    int too_many_ = 0;
    std::unique_ptr<compute::Buffer> before_;
    compute::SilhouetteChains chains_{stages(), compute::SilhouetteChains::Contours::on_surface};
};
INSTANTIATE_TEST_SUITE_P(OnDevice, ChainStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

std::vector<glm::vec3> places(std::size_t count) {
    return std::vector<glm::vec3>(count, glm::vec3{0});
}

TEST_P(ChainStage, ChainsStayWhatTheyAreWhileAnyOfTheirEdgesIsThere) {
    const Graph all{.vertices = places(5), .edges = {{0, 1}, {2, 1}, {2, 3}, {4, 3}}};
    Graph less = all;
    less.is_silhouette = {false, true, true, true};
    EXPECT_EQ(chains(less), (std::vector<FoundChain>{{{3, -1 - 2, 1}, false}})) << "by itself";
    follow();
    EXPECT_EQ(chains(all), (std::vector<FoundChain>{{{0, -1 - 1, 2, -1 - 3}, false}}));
    EXPECT_EQ(chains(less), (std::vector<FoundChain>{{{-1 - 1, 2, -1 - 3}, false}}));
    EXPECT_EQ(chains(all), (std::vector<FoundChain>{{{0, -1 - 1, 2, -1 - 3}, false}}));
}

TEST_P(ChainStage, RunsTheWayOfItsLeastEdge) {
    // Chains 4 - 2 - 0 - 3 and 1 - 5. Edge 1 is no silhouette.
    const Graph graph{.vertices = places(6),
                      .edges = {{2, 0}, {1, 0}, {3, 0}, {1, 5}, {4, 2}},
                      .is_silhouette = {true, false, true, true, true}};
    EXPECT_EQ(chains(graph), (std::vector<FoundChain>{{{4, 0, -1 - 2}, false}, {{3}, false}}));
}

TEST_P(ChainStage, LoopsBeginAtTheirLeastEdge) {
    const Graph graph{.vertices = places(8),
                      .edges = {{7, 6}, {2, 1}, {2, 3}, {3, 0}, {1, 0}, {6, 5}, {5, 7}}};
    EXPECT_EQ(chains(graph),
              (std::vector<FoundChain>{{{0, 5, 6}, true}, {{1, 4, -1 - 3, -1 - 2}, true}}));
}

TEST_P(ChainStage, GoesStraightOnWhereSeveralMeet) {
    // A cross at vertex 0 and a third line that ends there.
    const Graph graph{
        .vertices = {{0, 0, 0}, {1, 0.1F, 5}, {-1, 0, 0}, {0.1F, 1, 0}, {0, -1, 0}, {1, 1, 0}},
        .edges = {{0, 1}, {5, 0}, {3, 0}, {2, 0}, {0, 4}}};
    EXPECT_EQ(chains(graph),
              (std::vector<FoundChain>{{{3, 0}, false}, {{1}, false}, {{2, 4}, false}}));
}

TEST_P(ChainStage, OfNoSilhouettesThereAreNone) {
    EXPECT_TRUE(
        chains({.vertices = places(2), .edges = {{0, 1}}, .is_silhouette = {false}}).empty());
    EXPECT_EQ(chains({.vertices = places(2), .edges = {{0, 1}}}),
              (std::vector<FoundChain>{{{0}, false}}));
}

/// Chains of every length, open and closed, in any order and direction.
struct ManyChains {
    ManyChains(std::uint32_t most, std::mt19937& random) {
        for (std::uint32_t length = 1; length <= most; ++length) {
            for (const bool is_closed : {false, true}) {
                if (is_closed && length < 3) continue;
                (is_closed ? closed : open).push_back(length);
                const auto first = static_cast<std::uint32_t>(graph.vertices.size());
                const std::uint32_t count = is_closed ? length : length + 1;
                graph.vertices.resize(first + count);
                for (std::uint32_t k = 0; k < length; ++k) {
                    std::array edge{first + k, first + (k + 1) % count};
                    if (random() % 2 != 0) std::swap(edge[0], edge[1]);
                    graph.edges.push_back(edge);
                }
            }
        }
        std::ranges::shuffle(graph.edges, random);
    }

    Graph graph;
    std::vector<std::size_t> open, closed; ///< their lengths
};

/// All at once. The same tables serve for fewer and for more chains.
TEST_P(ChainStage, FindsEveryChainOfManyWhole) {
    std::mt19937 random{7};
    for (const std::uint32_t most : {9U, 70U, 40U}) {
        const ManyChains many{most, random};
        std::vector<std::size_t> open, closed;
        for (const FoundChain& chain : chains(many.graph))
            (chain.closed ? closed : open).push_back(chain.edges.size());
        std::ranges::sort(open);
        std::ranges::sort(closed);
        EXPECT_EQ(open, many.open);
        EXPECT_EQ(closed, many.closed);
    }
}

TEST_P(ChainStage, TheSameWhereTheirNumberIsGuessed) {
    std::mt19937 random{9};
    ManyChains many{40, random};
    const std::vector<FoundChain> all = chains(many.graph);
    many.graph.is_silhouette.resize(many.graph.edges.size());
    for (std::size_t i = 0; i < many.graph.edges.size(); ++i)
        many.graph.is_silhouette[i] = random() % 4 == 0;
    const std::vector<FoundChain> some = chains(many.graph);
    guess();
    EXPECT_EQ(chains(many.graph), some);
    EXPECT_EQ(too_many(), 0);
    many.graph.is_silhouette.clear();
    EXPECT_EQ(chains(many.graph), all);
    EXPECT_EQ(too_many(), 1);
    EXPECT_EQ(chains(many.graph), all);
    EXPECT_EQ(too_many(), 1);
    many.graph.is_silhouette.assign(many.graph.edges.size(), false);
    EXPECT_TRUE(chains(many.graph).empty());
    follow();
    many.graph.is_silhouette.clear();
    EXPECT_EQ(chains(many.graph), all);
    EXPECT_EQ(chains(many.graph), all) << "follows itself";
    EXPECT_EQ(too_many(), 2);
}

TEST_P(ChainStage, OfThousandsOfEdgesIsOne) {
    constexpr std::uint32_t count = 5000;
    std::mt19937 random{8};
    Graph graph{.vertices = places(count), .edges = {}};
    for (std::uint32_t k = 0; k < count; ++k) graph.edges.push_back({k, (k + 1) % count});
    std::ranges::shuffle(graph.edges, random);
    for (const bool closed : {true, false}) {
        if (!closed) graph.edges.pop_back();
        const std::vector<FoundChain> found = chains(graph);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].edges.size(), graph.edges.size());
        EXPECT_EQ(found[0].closed, closed);
    }
}

} // namespace
} // namespace lineatlas::test
