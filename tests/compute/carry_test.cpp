// carry: coordinates of silhouettes that edges of their chains had in the frame before.

#include <array>

#include "compute/stages/carried_coordinates.hpp"
#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

/// An edge of a chain: its candidate, and its place in the picture.
struct Edge {
    std::uint32_t candidate;
    bool turned = false;
    float length = 8; ///< pixels
    float t0 = 0, t1 = 1;
};
using Chain = std::vector<Edge>;

/// Coordinates at the start and end of an edge.
using Ends = std::array<float, 2>;

Chain row(std::uint32_t first, std::uint32_t count) {
    Chain chain;
    for (std::uint32_t i = 0; i < count; ++i) chain.push_back({first + i});
    return chain;
}

Chain joined(Chain a, const Chain& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

class CarryStage : public StageTest {
  protected:
    /// The coordinates of all edges of a frame. The chains run along straight lines. A line that is
    /// no silhouette comes before them in the table.
    std::vector<Ends> coordinates(const std::vector<Chain>& chains, float limit = 0) {
        std::vector<HandLine> lines{{.p = {0, 1, 0.5F, 1}, .q = {8, 1, 0.5F, 1}, .samples = 4}};
        std::vector<std::uint32_t> origins;
        for (const Chain& chain : chains) {
            float x = 0;
            const auto y = static_cast<float>(8 + 4 * (&chain - chains.data()));
            for (std::uint32_t i = 0; i < chain.size(); ++i) {
                const Edge& edge = chain[i];
                lines.push_back({.p = {x, y, 0.5F, 1},
                                 .q = {x + edge.length, y, 0.5F, 1},
                                 .samples = 4,
                                 .from_start = i,
                                 .to_end = static_cast<std::uint32_t>(chain.size()) - 1 - i,
                                 .tag = LA_KIND_SILHOUETTE,
                                 .t0 = edge.t0,
                                 .t1 = edge.t1});
                x += edge.length;
                origins.push_back((edge.candidate << 1U | (edge.turned ? 1U : 0U)) + 1);
            }
        }
        HandFrame frame{device(), lines};
        const auto vertices = put(std::vector<float>(3));
        const auto on_device = put(origins);
        compute::SegmentTable table = frame.table(*vertices);
        table.candidates = {.first = 1, .count = 64};
        table.origins = on_device.get();
        carried_.find(table, 1, frame.clipped(), glm::vec2{hand_size}, limit);
        return applied(frame);
    }
    void forget() { carried_.forget(); }

  private:
    /// The coordinates of a run of each whole line. The first run keeps its own.
    std::vector<Ends> applied(const HandFrame& frame) {
        std::vector<lineatlas::Run> runs(frame.count());
        for (std::uint32_t i = 0; i < runs.size(); ++i) {
            runs[i].start_arc = 100;
            runs[i].end_arc = 200;
            runs[i].stroke_start = 90;
            runs[i].stroke_end = 230;
            runs[i].end_sample = 4;
            runs[i].samples = 4;
            runs[i].segment = i;
        }
        const auto on_device = put(runs);
        const auto record = put(std::vector<FrameRecord>{{.points = {frame.count(), 1, 0, 0},
                                                          .sample_total = 0,
                                                          .run_total = frame.count(),
                                                          .raw_run_total = 0,
                                                          .unused = 0}});
        carried_.apply({*on_device, *record, frame.count()});
        runs = get<lineatlas::Run>(*on_device, frame.count());
        EXPECT_EQ(runs[0].start_arc, 100);
        EXPECT_EQ(runs[0].end_arc, 200);
        std::vector<Ends> result;
        for (std::size_t i = 1; i < runs.size(); ++i) {
            result.push_back({runs[i].start_arc, runs[i].end_arc});
            EXPECT_EQ(runs[i].start_arc - runs[i].stroke_start, 10);
            EXPECT_EQ(runs[i].stroke_end - runs[i].end_arc, 30);
        }
        return result;
    }

    compute::CarriedCoordinates carried_{stages()};
};
INSTANTIATE_TEST_SUITE_P(OnDevice, CarryStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

TEST_P(CarryStage, AtFirstZeroIsInTheMiddleOfAChain) {
    EXPECT_EQ(coordinates({row(0, 3), row(5, 2)}),
              (std::vector<Ends>{{-12, -4}, {-4, 4}, {4, 12}, {-8, 0}, {0, 8}}));
}

TEST_P(CarryStage, AChainThatLosesAnEdgeKeepsTheCoordinatesOfTheOthers) {
    coordinates({row(0, 4)});
    const std::vector<Ends> kept{{-8, 0}, {0, 8}, {8, 16}};
    EXPECT_EQ(coordinates({row(1, 3)}, 0.4F), kept);
    EXPECT_EQ(coordinates({row(1, 3)}, 0.4F), kept);
    forget();
    EXPECT_EQ(coordinates({row(1, 3)}, 0.4F), (std::vector<Ends>{{-12, -4}, {-4, 4}, {4, 12}}));
}

TEST_P(CarryStage, NewEdgesGoOnFromOldOnes) {
    coordinates({row(0, 2)});
    EXPECT_EQ(coordinates({joined(row(10, 1), joined(row(0, 2), row(20, 1)))}),
              (std::vector<Ends>{{-16, -8}, {-8, 0}, {0, 8}, {8, 16}}));
}

TEST_P(CarryStage, NewEdgesShareWhatLiesBetweenOldOnes) {
    coordinates({row(0, 3)});
    const Chain longer{{0}, {10, false, 4}, {11, false, 6}, {2}};
    EXPECT_EQ(coordinates({longer}),
              (std::vector<Ends>{{-12, -4}, {-4, -0.796875F}, {-0.796875F, 4}, {4, 12}}));
}

TEST_P(CarryStage, AnEdgeThatRunsTheOtherWayIsNew) {
    coordinates({{{0}, {1}}, {{2}}});
    EXPECT_EQ(coordinates({{{1, true}, {0, true}}, {{2}}}),
              (std::vector<Ends>{{-8, 0}, {0, 8}, {-4, 4}}));
}

TEST_P(CarryStage, ACoordinateStaysWithItsPlaceOnTheLine) {
    coordinates({{{0}}});
    // Half of the edge is left, twice as large.
    EXPECT_EQ(coordinates({{{0, false, 8, 0.5F, 1}}}, 0)[0][1], 4);
    EXPECT_NEAR(coordinates({{{0, false, 8, 0.5F, 1}}}, 0)[0][0], 0, 0.01);
}

TEST_P(CarryStage, LongPiecesOfDifferentChainsKeepTheirOwn) {
    coordinates({row(0, 10), row(20, 16)}); // -40 to 40, -64 to 64
    const std::vector<Ends> merged = coordinates({joined(row(0, 10), row(20, 16))}, 0.4F);
    EXPECT_EQ(merged.front(), (Ends{-40, -32}));
    EXPECT_EQ(merged[9], (Ends{32, 40}));
    EXPECT_EQ(merged[10], (Ends{-64, -56}));
    EXPECT_EQ(merged.back(), (Ends{56, 64}));
}

TEST_P(CarryStage, AShortPieceGivesWayUnlessThePictureStandsStill) {
    coordinates({row(0, 10), row(20, 3)}); // -40 to 40, -12 to 12
    const std::vector<Chain> merged{joined(row(0, 10), row(20, 3))};
    const std::vector<Ends> still = coordinates(merged);
    EXPECT_EQ(still[9], (Ends{32, 40}));
    EXPECT_EQ(still[10], (Ends{-12, -4}));
    const std::vector<Ends> moving = coordinates(merged, 0.1F);
    EXPECT_EQ(moving[9], (Ends{32, 40}));
    EXPECT_EQ(moving[10], (Ends{40, 48}));
    EXPECT_EQ(moving.back(), (Ends{56, 64}));
}

TEST_P(CarryStage, WhatIsStretchedShiftsTowardsTheOthersByHardlyMoreThanTheLimit) {
    const auto at = [](int units) { return static_cast<float>(units) / 256; };
    const Chain longer = joined(row(0, 2), joined({{10, false, 4}}, row(2, 2)));
    // Offsets of edges 0 to 3 are 0, 0, -4 and -4 pixels. From that of 1 to the mean of 0 to 2 it
    // is -1 1/3, in whole sixteenths -21/16, of which a quarter, -5/16, is -80/256. The mean of the
    // piece adds a fiftieth of -2, which is less than a sixteenth.
    for (const auto& [limit, shift] : {std::pair{0.4F, 80}, {0.2F, 51 + 1}}) {
        forget();
        coordinates({row(0, 4)});
        const std::vector<Ends> ends = coordinates({longer}, limit);
        EXPECT_EQ(ends[0], (Ends{-16, at(-8 * 256 - shift / 2)})); // halfway to what edge 1 does
        EXPECT_EQ(ends[1], (Ends{at(-8 * 256 - shift / 2), at(-shift)}));
        EXPECT_EQ(ends[2], (Ends{at(-shift), at(shift)}));
        EXPECT_EQ(ends[4], (Ends{at(8 * 256 + shift / 2), 16}));
    }
}

} // namespace
} // namespace lineatlas::test
