// Every stage on every device, stage by stage, each with the same input: `scan`, `halo`, `filter`
// and `density` against their oracles, which are written in another way, the others against `cpp`,
// which runs the same kernels through another compiler (on `cpp` itself: that it does not matter
// which threads do what). Four scenes, the small ones at three cameras, one of them inside the
// model; the large ones not on slow devices.

#include <algorithm>
#include <array>
#include <iostream>

#include "compare.hpp"
#include "compute/cpp/cpp_device.hpp"
#include "compute/oracles/frame_oracles.hpp"
#include "core/clusters.hpp"
#include "devices.hpp"
#include "gl_depth.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/scenes.hpp"
#include "scene_cameras.hpp"
#include "stages.hpp"

namespace lineatlas::test {
namespace {

constexpr int depth_scale = StageSettings{}.depth_scale;

template <class T>
testing::AssertionResult all_close(const std::vector<T>& a, const std::vector<T>& b) {
    if (a.size() != b.size()) {
        return testing::AssertionFailure() << "sizes " << a.size() << ", " << b.size();
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!close(a[i], b[i])) return testing::AssertionFailure() << "first difference at " << i;
    }
    return testing::AssertionSuccess();
}

/// The camera moved to the side, by less than a pixel for most of the picture.
Camera nudged(Camera camera) {
    camera.projection[2][0] += 0.7F / static_cast<float>(camera.size.x);
    camera.projection[2][1] += 0.4F / static_cast<float>(camera.size.y);
    return camera;
}

class StagesTest : public testing::TestWithParam<TestDevice> {
  protected:
    void compare_scene(const std::string& scene) {
        const LineSet& lines = scene_lines(scene);
        const FrameOracles oracles{lines};
        FrameStages cpp{compute::make_cpp_device(), lines};
        FrameStages device{GetParam().make(), lines};
        // `./run test` collects these lines about the devices on which the stages ran.
        std::cout << "stages of " << scene << " run on " << device.device().description() << '\n';
        const std::vector<Cluster> clusters =
            build_clusters(lines.vertices, lines.triangles, 64).clusters;
        for (const NamedCamera& view : few_scene_cameras(scene)) {
            SCOPED_TRACE(scene + " " + view.name);
            compare_frame(lines, oracles, cpp, device, view.camera,
                          draw_depth_by_gl(lines, view.camera, depth_scale));
            const std::vector<std::uint32_t> visible = cpp.cull(view.camera, clusters);
            EXPECT_TRUE(equal(visible, device.cull(view.camera, clusters)));
            EXPECT_GT(std::ranges::count(visible, 1), 0);
        }
    }

    static void compare_frame(const LineSet& lines, const FrameOracles& oracles, FrameStages& cpp,
                              FrameStages& device, const Camera& camera,
                              const std::vector<float>& depth) {
        FrameState expected;
        cpp.pyramid(camera, depth, expected);
        FrameState seen = expected;
        device.pyramid(camera, depth, seen);
        EXPECT_TRUE(equal(expected.tiles, seen.tiles));

        std::array<std::uint64_t, 2> samples{};
        for (const bool cull_hidden : {true, false}) {
            cpp.project(camera, cull_hidden, expected);
            seen = expected;
            device.project(camera, cull_hidden, seen);
            EXPECT_TRUE(equal(expected.front, seen.front));
            EXPECT_TRUE(equal(expected.counts, seen.counts));
            EXPECT_TRUE(equal(expected.lengths, seen.lengths));
            for (std::size_t i = 0; i < expected.counts.size(); ++i) {
                samples[cull_hidden ? 1 : 0] += expected.counts[i];
                if (expected.counts[i] == 0) continue; // may not be written
                ASSERT_TRUE(close(expected.clipped[i], seen.clipped[i])) << "segment " << i;
            }
        }
        EXPECT_LE(samples[1], samples[0]);

        oracles.scan(expected);
        seen = expected;
        device.scan(seen);
        EXPECT_TRUE(equal(expected.offsets, seen.offsets));
        EXPECT_TRUE(equal(expected.arcs, seen.arcs));
        ASSERT_GT(expected.offsets.back(), 0U)
            << "the view shows nothing: the test would prove nothing";

        cpp.atlas(camera, depth, expected);
        seen = expected;
        device.atlas(camera, depth, seen);
        EXPECT_TRUE(equal(expected.alpha, seen.alpha));

        cpp.tiled_atlas(camera, depth, seen);
        EXPECT_LE(compare_bytes(expected.alpha, seen.alpha).share(), 0.001);
        FrameState seen_tiles = expected;
        device.tiled_atlas(camera, depth, seen_tiles);
        EXPECT_TRUE(equal(seen.alpha, seen_tiles.alpha));

        FrameState before, current = expected;
        const Camera aside = nudged(camera);
        cpp.project(aside, false, before);
        oracles.scan(before);
        cpp.atlas(aside, draw_depth_by_gl(lines, aside, depth_scale), before);
        FrameState seen_current = current;
        cpp.temporal(before, current);
        device.temporal(before, seen_current);
        EXPECT_TRUE(equal(current.alpha, seen_current.alpha));
        EXPECT_FALSE(equal(current.alpha, expected.alpha)) << "nothing was averaged";

        cpp.compact(camera, expected);
        seen = expected;
        device.compact(camera, seen);
        EXPECT_EQ(expected.record.sample_total, seen.record.sample_total);
        EXPECT_EQ(expected.record.run_total, seen.record.run_total);
        EXPECT_EQ(seen.record.points[0], seen.record.run_total);
        EXPECT_GT(seen.record.run_total, 0U);
        EXPECT_TRUE(all_close(expected.runs, seen.runs));
        for (const bool hidden_too : {false, true}) {
            cpp.intervals(camera, depth, hidden_too, expected);
            device.intervals(camera, depth, hidden_too, seen);
            ASSERT_EQ(expected.intervals.size(), seen.intervals.size());
            EXPECT_GT(seen.intervals.size(), 0U);
            EXPECT_TRUE(all_close(expected.intervals, seen.intervals));
        }
        for (const std::uint32_t share : {2U, 3U, 5U}) {
            FrameState cut = expected;
            cut.alpha.resize(expected.offsets.back() / share);
            compare_with_a_small_atlas(oracles, cpp, device, camera, cut);
        }
        compare_effects(oracles, device, camera, expected);
    }

    /// Imitates the first try of a frame whose atlas has to grow. Overshooting strokes go on over
    /// segments that have no room in the atlas.
    static void compare_with_a_small_atlas(const FrameOracles& oracles, FrameStages& cpp,
                                           FrameStages& device, const Camera& camera,
                                           FrameState state) {
        cpp.compact(camera, state);
        if (state.runs.empty()) return; // all visible parts lie beyond the room
        state = compare_filter(oracles, device, camera, state);
        EXPECT_TRUE(std::ranges::all_of(state.runs, [&](const lineatlas::Run& run) {
            return (run.flags & LA_RUN_SOLID) != 0 ||
                   std::size_t{run.address} + run.samples <= state.alpha.size();
        }));
        FrameState seen = state;
        oracles.density(camera, state);
        device.density(camera, seen);
        EXPECT_TRUE(all_close(state.weights, seen.weights));
    }

    /// Returns the filtered state.
    static FrameState compare_filter(const FrameOracles& oracles, FrameStages& device,
                                     const Camera& camera, const FrameState& state) {
        FrameState filtered = state, seen = state;
        oracles.filter(camera, filtered);
        device.filter(camera, seen);
        EXPECT_EQ(filtered.record.run_total, seen.record.run_total);
        EXPECT_EQ(filtered.record.raw_run_total, seen.record.raw_run_total);
        EXPECT_TRUE(all_close(filtered.runs, seen.runs));
        EXPECT_TRUE(equal(filtered.alpha, seen.alpha));
        return filtered;
    }

    static void compare_effects(const FrameOracles& oracles, FrameStages& device,
                                const Camera& camera, FrameState& expected) {
        FrameState seen = expected;
        oracles.halo(camera, expected);
        device.halo(camera, seen);
        EXPECT_TRUE(all_close(expected.cuts, seen.cuts));

        FrameState without_gaps = expected;
        without_gaps.cuts.clear();
        compare_filter(oracles, device, camera, expected);
        // Without gaps, because overshoots end at gaps, and then perhaps no hidden part becomes
        // visible.
        const FrameState filtered = compare_filter(oracles, device, camera, without_gaps);
        EXPECT_FALSE(equal(filtered.alpha, expected.alpha)) << "nothing was changed";

        seen = expected;
        oracles.density(camera, expected);
        device.density(camera, seen);
        EXPECT_TRUE(equal(expected.flags, seen.flags));
        EXPECT_TRUE(all_close(expected.weights, seen.weights));
    }

    gl::HeadlessContext context_;
};

TEST_P(StagesTest, Clevis) {
    compare_scene("clevis");
}
TEST_P(StagesTest, House) {
    if (GetParam().slow) GTEST_SKIP();
    compare_scene("house");
}
TEST_P(StagesTest, Ship) {
    if (GetParam().slow) GTEST_SKIP();
    compare_scene("ship");
}
TEST_P(StagesTest, Office) {
    compare_scene("office");
}

TEST_P(StagesTest, NoSegmentsAtAll) {
    LineSet nothing;
    FrameStages device{GetParam().make(), nothing};
    const Camera camera = make_camera({.near = 1, .far = 2}, {64, 48}, {});
    FrameState state;
    device.pyramid(camera, std::vector<float>(64 * 48 * 4, 1.0F), state);
    device.project(camera, true, state);
    device.scan(state);
    EXPECT_TRUE(equal(state.offsets, {0}));
    device.atlas(camera, std::vector<float>(64 * 48 * 4, 1.0F), state);
    device.compact(camera, state);
    EXPECT_EQ(state.record.run_total, 0U);
    EXPECT_EQ(state.record.points[0], 0U);
    device.intervals(camera, std::vector<float>(64 * 48 * 4, 1.0F), true, state);
    EXPECT_TRUE(state.intervals.empty());
    device.halo(camera, state);
    device.density(camera, state);
    EXPECT_TRUE(equal(state.weights, std::vector<float>(state.weights.size(), 1.0F)));
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(StagesTest);
INSTANTIATE_TEST_SUITE_P(OnDevice, StagesTest, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lineatlas::test
