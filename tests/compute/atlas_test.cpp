// atlas: lines before and behind walls in a depth buffer of 64 by 64 texels. The probes that see
// the lines can be counted by hand.

#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

/// The value of a sample if `seen` of its probes see the line.
std::uint8_t share(std::uint32_t seen, std::uint32_t probes) {
    return static_cast<std::uint8_t>(std::lround(255.0 * seen / probes));
}

struct Scene {
    std::vector<HandLine> lines;
    std::vector<float> depth = std::vector<float>(64 * 64, 1.0F);
    float tolerance = 1e-4F;
    std::uint32_t probes = 3; ///< per axis
    std::uint32_t capacity = 4096;
    const compute::DepthTile* tile = nullptr;
    glm::ivec2 depth_size{64, 64};

    /// Adds a wall over the texels from low up to high, without high itself.
    void add_wall(glm::ivec2 low, glm::ivec2 high, float at) {
        for (int y = low.y; y < high.y; ++y) {
            for (int x = low.x; x < high.x; ++x) {
                depth[static_cast<std::size_t>(y * depth_size.x + x)] = at;
            }
        }
    }
};

class AtlasStage : public StageTest {
  protected:
    /// The samples of a scene. Texels without a sample stay 99.
    std::vector<std::uint8_t> alpha_of(const Scene& scene) {
        HandFrame frame{device(), scene.lines};
        const auto depth = put(scene.depth);
        const auto alpha = put(std::vector<std::uint8_t>(8192, 99));
        stages().atlas({.segment_count = frame.count(),
                        .atlas = {frame.clipped(), *alpha, scene.capacity},
                        .depth = {*depth, scene.depth_size, 1, scene.tolerance},
                        .viewport = glm::vec2{hand_size},
                        .probes = scene.probes,
                        .tile = scene.tile});
        return get<std::uint8_t>(*alpha, 8192);
    }
    /// The only sample of a line from 10 to 12 pixels at this height.
    std::uint8_t sample_of(Scene scene, float y, float depth = 0.5F) {
        scene.lines = {{{10, y, depth, 1}, {12, y, depth, 1}, 1}};
        return alpha_of(scene)[0];
    }
    static std::vector<std::uint8_t> first(const std::vector<std::uint8_t>& alpha, std::size_t n) {
        return {alpha.begin(), alpha.begin() + static_cast<std::ptrdiff_t>(n)};
    }
};
INSTANTIATE_TEST_SUITE_P(OnDevice, AtlasStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

TEST_P(AtlasStage, SamplesBehindAWallAreHidden) {
    Scene scene{{{{10, 20.5F, 0.5F, 1}, {50, 20.5F, 0.5F, 1}, 20}}};
    scene.add_wall({30, 0}, {64, 64}, 0.3F);
    std::vector<std::uint8_t> expected(20, 255);
    std::fill(expected.begin() + 10, expected.end(), 0);
    for (const std::uint32_t probes : {1U, 2U, 3U, 4U}) {
        scene.probes = probes;
        EXPECT_TRUE(equal(first(alpha_of(scene), 20), expected)) << probes;
    }
}

TEST_P(AtlasStage, ProbesFillABoxAPixelWide) {
    // In every row along the line the probe is farther to the left than in the row before. With
    // three by three probes the places are -4/9 to 4/9 of a pixel, each once. The wall begins 0.2
    // to the left.
    Scene scene;
    scene.add_wall({0, 21}, {64, 64}, 0.3F);
    const std::uint32_t seen[] = {1, 3, 6, 11};
    for (std::uint32_t probes = 1; probes <= 4; ++probes) {
        scene.probes = probes;
        EXPECT_EQ(sample_of(scene, 20.8F), share(seen[probes - 1], probes * probes)) << probes;
    }
    scene.probes = 3;
    EXPECT_EQ(sample_of(scene, 20.6F), share(8, 9));
    EXPECT_EQ(sample_of(scene, 20.5F), 255);
    EXPECT_EQ(sample_of(scene, 21.5F), 0);
    EXPECT_EQ(sample_of(scene, 21.4F), share(1, 9));
}

TEST_P(AtlasStage, ProbesAreSpreadAlongTheSample) {
    // One sample goes from pixel 20 to 29, and the wall hides its end. The probes are at ninths of
    // the sample, 0.5 to 8.5 pixels from its start.
    for (int wall = 20; wall <= 29; ++wall) {
        Scene scene{{{{20, 30.5F, 0.5F, 1}, {29, 30.5F, 0.5F, 1}, 1}}};
        scene.add_wall({wall, 0}, {64, 64}, 0.3F);
        EXPECT_EQ(alpha_of(scene)[0], share(static_cast<std::uint32_t>(wall - 20), 9)) << wall;
    }
}

TEST_P(AtlasStage, NearerByLessThanTheToleranceDoesNotHide) {
    Scene scene;
    scene.add_wall({0, 0}, {64, 64}, 0.49F);
    scene.tolerance = 0.011F;
    EXPECT_EQ(sample_of(scene, 20.5F), 255);
    scene.tolerance = 0.009F;
    EXPECT_EQ(sample_of(scene, 20.5F), 0);
    // The tolerance is divided by w, which goes from 1 to 4. On the screen 1/w falls in a straight
    // line.
    scene.tolerance = 0.02F; // 0.01 where 1/w is a half, at two thirds of the way
    scene.lines = {{{0, 20.5F, 0.5F, 1}, {48, 20.5F, 0.5F, 4}, 24}};
    std::vector<std::uint8_t> expected(24, 255);
    std::fill(expected.begin() + 16, expected.end(), 0);
    EXPECT_TRUE(equal(first(alpha_of(scene), 24), expected));
}

TEST_P(AtlasStage, DepthIsThatOfTheLineBesideEachTexel) {
    // The line goes from depth 0.25 to 0.75 over 32 pixels. From the middle on it is behind a wall
    // at depth 0.5.
    Scene scene{{{{10, 20.5F, 0.25F, 1}, {42, 20.5F, 0.75F, 1}, 16}}};
    scene.add_wall({0, 0}, {64, 64}, 0.5F);
    std::vector<std::uint8_t> expected(16, 255);
    std::fill(expected.begin() + 8, expected.end(), 0);
    EXPECT_TRUE(equal(first(alpha_of(scene), 16), expected));
    // A line with the wall's slope is visible everywhere, because each texel holds the depth at its
    // centre.
    for (int x = 0; x < 64; ++x) {
        scene.add_wall({x, 0}, {x + 1, 64}, 0.25F + (static_cast<float>(x) + 0.5F - 10) / 64);
    }
    EXPECT_TRUE(equal(first(alpha_of(scene), 16), std::vector<std::uint8_t>(16, 255)));
}

TEST_P(AtlasStage, ItsOwnFaceDoesNotHideALine) {
    // A face that comes nearer by 1/64 per pixel to the left. The row of texels above the line has
    // its centre 0.7 pixels above the line.
    const auto with_face = [&](float slope, float height, float row_depth) {
        Scene scene{{{{10, 20.8F, 0.5F, 1}, {12, 20.8F, 0.5F, 1}, 1}}};
        scene.lines[0].own_b = pack_own_face(slope, height);
        scene.add_wall({0, 21}, {64, 22}, row_depth);
        return alpha_of(scene)[0];
    };
    const float own = 0.5F - 0.7F / 64;
    EXPECT_EQ(with_face(-1.0F / 64, 10, own), 255);
    EXPECT_EQ(with_face(-1.0F / 64, 10, own - 2e-4F), share(6, 9)) << "something before it";
    EXPECT_EQ(with_face(-1.0F / 64, -10, own), share(6, 9)) << "the face is on the other side";
    EXPECT_EQ(with_face(-1.0F / 64, 0.5F, own), share(6, 9)) << "and lower than that";
    EXPECT_EQ(with_face(-1.0F / 32, 10, own), share(6, 9)) << "and steeper";
}

TEST_P(AtlasStage, ASingleProbeStandsOutsideAFold) {
    Scene scene;
    scene.probes = 1;
    scene.add_wall({0, 0}, {64, 20}, 0.3F); // half a pixel to the right
    scene.lines = {{{10, 20.5F, 0.5F, 1}, {12, 20.5F, 0.5F, 1}, 1}};
    EXPECT_EQ(alpha_of(scene)[0], 255);
    const auto folded = [&](float height_a, float height_b) {
        scene.lines[0].own_a = pack_own_face(0, height_a);
        scene.lines[0].own_b = pack_own_face(0, height_b);
        return alpha_of(scene)[0];
    };
    EXPECT_EQ(folded(3, 2), 0) << "both faces on the left";
    EXPECT_EQ(folded(-3, -2), 255);
    EXPECT_EQ(folded(3, -2), 255);
}

TEST_P(AtlasStage, OfASlantedLineProbesStandAcrossItToo) {
    // The wall begins at the line and goes on to its right: three quarters of a pixel to the left,
    // half a pixel to the left and half a pixel up, nothing is before it.
    Scene scene;
    scene.probes = 1;
    for (int x = 0; x < 64; ++x) scene.add_wall({x, 0}, {x + 1, x + 1}, 0.3F);
    scene.lines = {{{19.6F, 19.6F, 0.5F, 1}, {20.6F, 20.6F, 0.5F, 1}, 1}};
    EXPECT_EQ(alpha_of(scene)[0], 0);
    scene.lines[0].own_a = pack_own_face(0, -3); // a fold whose faces are on the right
    scene.lines[0].own_b = pack_own_face(0, -2);
    EXPECT_EQ(alpha_of(scene)[0], 255);
}

TEST_P(AtlasStage, SamplesLieOneAfterTheOther) {
    Scene scene{{{{10, 20.5F, 0.5F, 1}, {50, 20.5F, 0.5F, 1}, 20},
                 {{10, 30.5F, 0.5F, 1}, {20, 30.5F, 0.5F, 1}, 5}}};
    scene.add_wall({0, 0}, {64, 25}, 0.3F); // hides the first line
    std::vector<std::uint8_t> expected(40, 99);
    std::fill_n(expected.begin(), 20, 0);
    std::fill_n(expected.begin() + 20, 5, 255);
    EXPECT_TRUE(equal(first(alpha_of(scene), 40), expected));
    scene.capacity = 22;
    std::fill_n(expected.begin() + 22, 3, 99);
    EXPECT_TRUE(equal(first(alpha_of(scene), 40), expected));
}

TEST_P(AtlasStage, OfATileOnlyItsCoreIsComputed) {
    Scene scene{{{{10, 40.5F, 0.5F, 1}, {50, 40.5F, 0.5F, 1}, 20}}};
    // A tile of 32 by 16 texels from (24, 32) on, and a wall from 40 on.
    const compute::DepthTile tile{.origin = {24, 32}, .core_low = {26, 34}, .core_high = {46, 46}};
    scene.tile = &tile;
    scene.depth_size = {32, 16};
    scene.add_wall({16, 0}, {32, 16}, 0.3F);
    const std::vector<std::uint8_t> alpha = alpha_of(scene);
    for (std::size_t j = 0; j < 20; ++j) { // its middle at 11 + 2 j
        EXPECT_EQ(alpha[j], j < 8 || j > 17 ? 99 : j < 15 ? 255 : 0) << j;
    }
}

} // namespace
} // namespace lineatlas::test
