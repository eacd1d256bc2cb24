// Every stage on every device against the plain C++ backend, stage by stage: each gets the
// reference's input. Four scenes, three cameras each, one of them inside the model.

#include <algorithm>
#include <array>

#include <glm/gtc/matrix_inverse.hpp>

#include "compare.hpp"
#include "core/clusters.hpp"
#include "core/tiles.hpp"
#include "devices.hpp"
#include "glpasses/depth_pass.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/scenes.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

using compute::Backend;
using compute::Buffer;

constexpr int depth_scale = 2;
constexpr std::uint32_t run_capacity = 1U << 20U;

/// The state of a frame after some stage, on the host.
struct FrameState {
    std::vector<std::uint8_t> front;
    std::vector<float> tiles;
    std::vector<ClippedSegment> clipped;
    std::vector<std::uint32_t> counts, lengths; ///< after project_clip
    std::vector<std::uint32_t> offsets, arcs;   ///< after scan
    std::vector<std::uint8_t> alpha;
    std::vector<Interval> intervals;
    std::vector<Run> runs;
    FrameRecord record{};
    std::vector<RunCuts> cuts;
    std::vector<std::uint32_t> flags; ///< of the runs, after density
    std::vector<float> weights;
};

/// One backend's buffers for a line set, and its stages one at a time.
class Stages {
  public:
    Stages(std::unique_ptr<Backend> backend, const LineSet& lines)
        : backend_(std::move(backend)), n_(static_cast<std::uint32_t>(lines.segments.size())),
          triangle_count_(static_cast<std::uint32_t>(lines.triangles.size())),
          vertices_(to_device(*backend_, lines.vertices)),
          triangles_(to_device(*backend_, lines.triangles)),
          segments_(to_device(*backend_, lines.segments)),
          front_(to_device(*backend_, std::vector<std::uint8_t>(triangle_count_))),
          // Zeros where nothing is written, so that tables can be compared whole.
          clipped_(to_device(*backend_, std::vector<ClippedSegment>(n_))),
          offsets_(backend_->allocate((n_ + 1) * sizeof(std::uint32_t))),
          arcs_(backend_->allocate((n_ + 1) * sizeof(std::uint32_t))) {}

    void pyramid(const Camera& camera, const std::vector<float>& depth, FrameState& state) {
        const glm::ivec2 size = camera.size * depth_scale;
        const glm::ivec2 count = compute::tiles_for(size);
        const auto depth_buffer = to_device(*backend_, depth);
        state.tiles.resize(static_cast<std::size_t>(count.x * count.y));
        tiles_ = to_device(*backend_, state.tiles);
        backend_->pyramid({.depth = *depth_buffer, .depth_size = size, .tiles = *tiles_});
        state.tiles = read_back<float>(*backend_, *tiles_, state.tiles.size());
    }

    /// Against the pyramid of the last call.
    std::vector<std::uint8_t> cull(const Camera& camera, const std::vector<Cluster>& clusters) {
        const auto count = static_cast<std::uint32_t>(clusters.size());
        const auto buffer = to_device(*backend_, clusters);
        const auto visible = backend_->allocate(count);
        backend_->cull({.clusters = *buffer,
                        .count = count,
                        .clip_from_world = camera.clip_from_world(),
                        .depth_size = camera.size * depth_scale,
                        .tiles = *tiles_,
                        .visible = *visible});
        return read_back<std::uint8_t>(*backend_, *visible, count);
    }

    /// With the pyramid of the last call if `cull_hidden`.
    void project(const Camera& camera, bool cull_hidden, FrameState& state) {
        const compute::OcclusionTest occlusion{.tiles = *tiles_,
                                               .tile_count =
                                                   compute::tiles_for(camera.size * depth_scale),
                                               .depth_scale = depth_scale,
                                               .tolerance = depth_tolerance(camera)};
        const glm::mat4 clip_from_world = camera.clip_from_world();
        backend_->facing({.table = table(), .eye = camera.eye(), .front = *front_});
        state.front = read_back<std::uint8_t>(*backend_, *front_, triangle_count_);
        backend_->project_clip(
            {.table = table(),
             .front = *front_,
             .clip_from_world = clip_from_world,
             .world_from_clip = glm::mat4{glm::inverse(glm::dmat4{clip_from_world})},
             .viewport = glm::vec2{camera.size},
             .step = 2,
             .kind_mask = all_line_kinds,
             .occlusion = cull_hidden ? &occlusion : nullptr,
             .out = {*clipped_, *offsets_, *arcs_}});
        state.counts = read_back<std::uint32_t>(*backend_, *offsets_, n_);
        state.lengths = read_back<std::uint32_t>(*backend_, *arcs_, n_);
        state.clipped = read_back<ClippedSegment>(*backend_, *clipped_, n_);
    }

    void scan(FrameState& state) {
        set(offsets_, state.counts);
        set(arcs_, state.lengths);
        backend_->scan(*offsets_, n_, compute::ScanKind::saturate);
        backend_->scan(*arcs_, n_, compute::ScanKind::wrap);
        state.offsets = read_back<std::uint32_t>(*backend_, *offsets_, n_ + 1);
        state.arcs = read_back<std::uint32_t>(*backend_, *arcs_, n_ + 1);
    }

    void atlas(const Camera& camera, const std::vector<float>& depth, const AtlasLayout& layout,
               FrameState& state) {
        set(clipped_, state.clipped);
        set(offsets_, state.offsets);
        const auto depth_buffer = to_device(*backend_, depth);
        const std::uint32_t total = state.offsets.back();
        const auto alpha =
            to_device(*backend_, std::vector<std::uint8_t>(layout.texels(total) + 64));
        backend_->atlas({.clipped = {*clipped_, *offsets_, *arcs_},
                         .segment_count = n_,
                         .depth = *depth_buffer,
                         .depth_size = camera.size * depth_scale,
                         .viewport = glm::vec2{camera.size},
                         .depth_scale = depth_scale,
                         .probes = 3,
                         .tolerance = depth_tolerance(camera),
                         .layout = layout,
                         .capacity = total,
                         .alpha = *alpha});
        state.alpha = read_back<std::uint8_t>(*backend_, *alpha, layout.texels(total) + 64);
    }

    /// The same with a depth buffer that is cut into tiles.
    void tiled_atlas(const Camera& camera, const std::vector<float>& depth,
                     const AtlasLayout& layout, FrameState& state) {
        constexpr int tile_pixels = 130, reach = 6;
        const std::uint32_t total = state.offsets.back();
        const glm::ivec2 whole = camera.size * depth_scale;
        set(clipped_, state.clipped);
        set(offsets_, state.offsets);
        const auto alpha =
            to_device(*backend_, std::vector<std::uint8_t>(layout.texels(total) + 64));
        for (const PictureTile& tile : make_tiles(camera.size, tile_pixels)) {
            const glm::ivec2 low = glm::max(tile.low * depth_scale - reach, 0);
            const glm::ivec2 high = glm::min((tile.low + tile.size) * depth_scale + reach, whole);
            std::vector<float> part;
            for (int y = low.y; y < high.y; ++y) {
                const auto row = depth.begin() + static_cast<std::ptrdiff_t>(y) * whole.x;
                part.insert(part.end(), row + low.x, row + high.x);
            }
            // Segments end at the borders of the picture.
            const auto outer = [](int at, int border, int beyond) {
                return at == border ? beyond : at;
            };
            const glm::ivec2 core = tile.low * depth_scale;
            const glm::ivec2 core_end = (tile.low + tile.size) * depth_scale;
            const compute::DepthTile place{.origin = low,
                                           .core_low = {outer(core.x, 0, -9), outer(core.y, 0, -9)},
                                           .core_high = {outer(core_end.x, whole.x, whole.x + 9),
                                                         outer(core_end.y, whole.y, whole.y + 9)}};
            const auto buffer = to_device(*backend_, part);
            backend_->atlas({.clipped = {*clipped_, *offsets_, *arcs_},
                             .segment_count = n_,
                             .depth = *buffer,
                             .depth_size = high - low,
                             .viewport = glm::vec2{camera.size},
                             .depth_scale = depth_scale,
                             .probes = 3,
                             .tolerance = depth_tolerance(camera),
                             .layout = layout,
                             .capacity = total,
                             .alpha = *alpha,
                             .tile = &place});
            backend_->finish();
        }
        state.alpha = read_back<std::uint8_t>(*backend_, *alpha, layout.texels(total) + 64);
    }

    /// Averages `now` with the frame before it.
    void temporal(const AtlasLayout& layout, const FrameState& before, FrameState& now) {
        const std::uint32_t room = std::max(before.offsets.back(), now.offsets.back());
        const std::size_t texels = layout.texels(room) + 64;
        const auto history_alpha = to_device(*backend_, std::vector<std::uint8_t>(texels));
        const auto history_offsets = to_device(*backend_, std::vector<std::uint32_t>(n_ + 1));
        const auto ranges = to_device(*backend_, std::vector<std::uint32_t>(n_));
        for (const FrameState* frame : {&before, static_cast<const FrameState*>(&now)}) {
            set(clipped_, frame->clipped);
            set(offsets_, frame->offsets);
            std::vector<std::uint8_t> padded = frame->alpha;
            padded.resize(texels);
            const auto alpha = to_device(*backend_, padded);
            backend_->temporal({.clipped = {*clipped_, *offsets_, *arcs_},
                                .segment_count = n_,
                                .layout = layout,
                                .capacity = room,
                                .alpha = *alpha,
                                .history = {*history_alpha, *history_offsets, *ranges},
                                .use_history = frame != &before});
            if (frame == &before) continue;
            padded = read_back<std::uint8_t>(*backend_, *alpha, texels);
            EXPECT_TRUE(equal(padded, read_back<std::uint8_t>(*backend_, *history_alpha, texels)));
            padded.resize(now.alpha.size());
            now.alpha = padded;
        }
    }

    void compact(const Camera& camera, const AtlasLayout& layout, FrameState& state) {
        set(clipped_, state.clipped);
        set(offsets_, state.offsets);
        set(arcs_, state.arcs);
        const auto alpha = to_device(*backend_, state.alpha);
        const auto runs = backend_->allocate(run_capacity * sizeof(Run));
        const auto record = backend_->allocate(sizeof(FrameRecord));
        backend_->compact_runs({.table = table(),
                                .clipped = {*clipped_, *offsets_, *arcs_},
                                .alpha = *alpha,
                                .layout = layout,
                                .capacity = state.offsets.back(),
                                .viewport = glm::vec2{camera.size},
                                .half_width = 1,
                                .runs = *runs,
                                .run_capacity = run_capacity,
                                .record = *record});
        state.record = read_back<FrameRecord>(*backend_, *record, 1)[0];
        state.runs = read_back<Run>(*backend_, *runs, state.record.points[0]);
    }

    void intervals(const Camera& camera, const std::vector<float>& depth, const AtlasLayout& layout,
                   bool hidden_too, FrameState& state) {
        set(clipped_, state.clipped);
        set(offsets_, state.offsets);
        set(arcs_, state.arcs);
        const auto alpha = to_device(*backend_, state.alpha);
        const auto depth_buffer = to_device(*backend_, depth);
        const auto table = backend_->allocate(run_capacity * sizeof(Interval));
        const auto total = backend_->allocate(sizeof(std::uint32_t));
        backend_->intervals({.table = this->table(),
                             .clipped = {*clipped_, *offsets_, *arcs_},
                             .alpha = *alpha,
                             .layout = layout,
                             .capacity = state.offsets.back(),
                             .viewport = glm::vec2{camera.size},
                             .depth = *depth_buffer,
                             .depth_size = camera.size * depth_scale,
                             .depth_scale = depth_scale,
                             .tolerance = depth_tolerance(camera),
                             .hidden_too = hidden_too,
                             .intervals = *table,
                             .interval_capacity = run_capacity,
                             .total = *total});
        const std::uint32_t count = read_back<std::uint32_t>(*backend_, *total, 1)[0];
        state.intervals = read_back<Interval>(*backend_, *table, count);
    }

    /// Of the runs in `state`.
    void halo(const Camera& camera, FrameState& state) {
        set(clipped_, state.clipped);
        const auto runs = to_device(*backend_, state.runs);
        const auto record = to_device(*backend_, std::vector{state.record});
        const auto cuts = backend_->allocate(state.runs.size() * sizeof(RunCuts));
        backend_->halo({.table = table(),
                        .clipped = {*clipped_, *offsets_, *arcs_},
                        .runs = *runs,
                        .record = *record,
                        .run_capacity = static_cast<std::uint32_t>(state.runs.size()),
                        .viewport = glm::vec2{camera.size},
                        .halo = 3,
                        .half_width = 1,
                        .tolerance = depth_tolerance(camera),
                        .cuts = *cuts});
        state.cuts = read_back<RunCuts>(*backend_, *cuts, state.runs.size());
    }

    /// Of the runs in `state`, and with its gaps.
    void filter(const Camera& camera, const AtlasLayout& layout, FrameState& state) {
        set(clipped_, state.clipped);
        set(offsets_, state.offsets);
        set(arcs_, state.arcs);
        const auto alpha = to_device(*backend_, state.alpha);
        const auto runs = to_device(*backend_, state.runs);
        const auto record = to_device(*backend_, std::vector{state.record});
        const auto cuts = to_device(*backend_, state.cuts);
        const auto filtered = backend_->allocate(run_capacity * sizeof(Run));
        const auto filtered_record = backend_->allocate(sizeof(FrameRecord));
        backend_->filter({.table = table(),
                          .clipped = {*clipped_, *offsets_, *arcs_},
                          .alpha = *alpha,
                          .layout = layout,
                          .viewport = glm::vec2{camera.size},
                          .half_width = 1,
                          .fill = 4,
                          .drop = 4,
                          .overshoot = 12,
                          .overshoot_variation = 0.3F,
                          .undershoot = 2,
                          .runs = *runs,
                          .record = *record,
                          .cuts = cuts.get(),
                          .run_capacity = static_cast<std::uint32_t>(state.runs.size()),
                          .filtered = *filtered,
                          .filtered_capacity = run_capacity,
                          .filtered_record = *filtered_record});
        state.record = read_back<FrameRecord>(*backend_, *filtered_record, 1)[0];
        state.runs = read_back<Run>(*backend_, *filtered, state.record.points[0]);
        state.alpha = read_back<std::uint8_t>(*backend_, *alpha, state.alpha.size());
    }

    /// Of the runs in `state`, with a limit that hides some.
    void density(const Camera& camera, const AtlasLayout& layout, FrameState& state) {
        set(arcs_, state.arcs);
        const auto alpha = to_device(*backend_, state.alpha);
        const auto runs = to_device(*backend_, state.runs);
        const auto record = to_device(*backend_, std::vector{state.record});
        const glm::vec2 viewport{camera.size};
        const glm::ivec2 cells = compute::density_cells(viewport);
        const auto count = LA_DENSITY_BINS * static_cast<std::size_t>(cells.x * cells.y);
        const auto weights = backend_->allocate(count * sizeof(float));
        backend_->density({.table = table(),
                           .clipped = {*clipped_, *offsets_, *arcs_},
                           .alpha = *alpha,
                           .layout = layout,
                           .runs = *runs,
                           .record = *record,
                           .run_capacity = static_cast<std::uint32_t>(state.runs.size()),
                           .viewport = viewport,
                           .limit = 0.1F,
                           .priority = {0.5F, 0.6F, 0.5F, 1, 1},
                           .focus = {0.4F * viewport.x, 0.6F * viewport.y, 30, 80},
                           .far_limit = 0.5F,
                           .weights = *weights});
        state.weights = read_back<float>(*backend_, *weights, count);
        state.flags.clear();
        for (const Run& run : read_back<Run>(*backend_, *runs, state.runs.size())) {
            state.flags.push_back(run.flags);
        }
    }

  private:
    /// One pixel's width in window depth, times w.
    static float depth_tolerance(const Camera& camera) {
        return std::fabs(camera.projection[3][2] /
                         (camera.projection[1][1] * static_cast<float>(camera.size.y)));
    }
    compute::SegmentTable table() {
        return {*vertices_, *triangles_, *segments_, triangle_count_, n_};
    }
    template <class T>
    void set(std::unique_ptr<Buffer>& buffer, const std::vector<T>& values) {
        backend_->upload(*buffer, std::as_bytes(std::span{values}));
    }

    std::unique_ptr<Backend> backend_;
    std::uint32_t n_, triangle_count_;
    std::unique_ptr<Buffer> vertices_, triangles_, segments_, front_, clipped_, offsets_, arcs_,
        tiles_;
};

/// The scene's depth at a camera, drawn by GL.
std::vector<float> draw_depth(const LineSet& lines, const Camera& camera) {
    const auto upload = [](const auto& values) {
        gl::Buffer buffer = gl::Buffer::create();
        const auto bytes = std::as_bytes(std::span{values});
        glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(bytes.size()), bytes.data(), 0);
        return buffer;
    };
    const gl::Buffer vertices = upload(lines.vertices);
    const gl::Buffer indices = upload(lines.triangles);
    gl::DepthPass pass;
    pass.begin(camera.size, depth_scale);
    pass.draw({.vertices = vertices.id(),
               .indices = indices.id(),
               .triangle_count = static_cast<std::uint32_t>(lines.triangles.size())},
              camera.clip_from_world());
    std::vector<float> depth(static_cast<std::size_t>(pass.size().x) *
                             static_cast<std::size_t>(pass.size().y));
    glGetTextureImage(pass.texture(), 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                      static_cast<GLsizei>(depth.size() * sizeof(float)), depth.data());
    return depth;
}

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

/// As seen from a step aside, under a pixel for most of the picture.
Camera nudged(Camera camera) {
    camera.projection[2][0] += 0.7F / static_cast<float>(camera.size.x);
    camera.projection[2][1] += 0.4F / static_cast<float>(camera.size.y);
    return camera;
}

template <class T>
std::size_t different(const std::vector<T>& a, const std::vector<T>& b) {
    std::size_t count = a.size() == b.size() ? 0 : a.size() + b.size();
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        if (!close(a[i], b[i])) ++count;
    }
    return count;
}

class StagesTest : public testing::TestWithParam<TestDevice> {
  protected:
    void compare_scene(const std::string& scene) {
        const LineSet& lines = scene_lines(scene);
        Stages reference{compute::make_reference_backend(), lines};
        Stages device{GetParam().backend(), lines};
        const std::vector<Cluster> clusters =
            build_clusters(lines.vertices, lines.triangles, 64).clusters;
        for (const NamedCamera& view : scene_cameras(scene)) {
            SCOPED_TRACE(scene + " " + view.name);
            compare_frame(lines, reference, device, view.camera, draw_depth(lines, view.camera));
            const std::vector<std::uint8_t> visible = reference.cull(view.camera, clusters);
            EXPECT_TRUE(equal(visible, device.cull(view.camera, clusters)));
            EXPECT_GT(std::ranges::count(visible, 1), 0);
        }
    }

    static void compare_frame(const LineSet& lines, Stages& reference, Stages& device,
                              const Camera& camera, const std::vector<float>& depth) {
        FrameState expected;
        reference.pyramid(camera, depth, expected);
        FrameState seen = expected;
        device.pyramid(camera, depth, seen);
        EXPECT_TRUE(equal(expected.tiles, seen.tiles));

        std::array<std::uint64_t, 2> samples{};
        for (const bool cull_hidden : {true, false}) {
            reference.project(camera, cull_hidden, expected);
            seen = expected;
            device.project(camera, cull_hidden, seen);
            EXPECT_TRUE(equal(expected.front, seen.front));
            EXPECT_TRUE(equal(expected.counts, seen.counts));
            EXPECT_TRUE(equal(expected.lengths, seen.lengths));
            for (std::size_t i = 0; i < expected.counts.size(); ++i) {
                samples[cull_hidden ? 1 : 0] += expected.counts[i];
                if (expected.counts[i] == 0) continue; // perhaps not written
                ASSERT_TRUE(close(expected.clipped[i], seen.clipped[i])) << "segment " << i;
            }
        }
        EXPECT_LE(samples[1], samples[0]);

        reference.scan(expected);
        seen = expected;
        device.scan(seen);
        EXPECT_TRUE(equal(expected.offsets, seen.offsets));
        EXPECT_TRUE(equal(expected.arcs, seen.arcs));
        ASSERT_GT(expected.offsets.back(), 0U)
            << "the view shows nothing: the test would prove nothing";

        for (const auto kind : {AtlasLayoutKind::wrap, AtlasLayoutKind::gutter}) {
            const AtlasLayout layout = make_atlas_layout(kind, 401, 16384);
            reference.atlas(camera, depth, layout, expected);
            seen = expected;
            device.atlas(camera, depth, layout, seen);
            const ByteDifference difference = compare_bytes(expected.alpha, seen.alpha);
            EXPECT_LE(difference.share(), 0.001) << "largest " << difference.largest;

            reference.tiled_atlas(camera, depth, layout, seen);
            EXPECT_LE(compare_bytes(expected.alpha, seen.alpha).share(), 0.001);
            FrameState seen_tiles = expected;
            device.tiled_atlas(camera, depth, layout, seen_tiles);
            EXPECT_LE(compare_bytes(seen.alpha, seen_tiles.alpha).share(), 0.001);

            FrameState before, current = expected;
            const Camera aside = nudged(camera);
            reference.project(aside, false, before);
            reference.scan(before);
            reference.atlas(aside, draw_depth(lines, aside), layout, before);
            FrameState seen_current = current;
            reference.temporal(layout, before, current);
            device.temporal(layout, before, seen_current);
            EXPECT_TRUE(equal(current.alpha, seen_current.alpha));
            EXPECT_FALSE(equal(current.alpha, expected.alpha)) << "nothing was averaged";

            reference.compact(camera, layout, expected);
            seen = expected;
            device.compact(camera, layout, seen);
            EXPECT_EQ(expected.record.sample_total, seen.record.sample_total);
            EXPECT_EQ(expected.record.run_total, seen.record.run_total);
            EXPECT_EQ(seen.record.points[0], seen.record.run_total);
            EXPECT_EQ(seen.record.quads[1], seen.record.run_total);
            EXPECT_GT(seen.record.run_total, 0U);
            EXPECT_TRUE(all_close(expected.runs, seen.runs));
            for (const bool hidden_too : {false, true}) {
                reference.intervals(camera, depth, layout, hidden_too, expected);
                device.intervals(camera, depth, layout, hidden_too, seen);
                ASSERT_EQ(expected.intervals.size(), seen.intervals.size());
                EXPECT_GT(seen.intervals.size(), 0U);
                // Where two steps of a search tie, rounding decides.
                EXPECT_LE(different(expected.intervals, seen.intervals),
                          expected.intervals.size() / 1000);
            }
            compare_effects(reference, device, camera, layout, expected);
        }
    }

    static void compare_effects(Stages& reference, Stages& device, const Camera& camera,
                                const AtlasLayout& layout, FrameState& expected) {
        FrameState seen = expected;
        reference.halo(camera, expected);
        device.halo(camera, seen);
        // Where a line just reaches another, rounding decides whether they cross.
        EXPECT_LE(different(expected.cuts, seen.cuts), expected.cuts.size() / 1000);

        FrameState filtered = expected;
        reference.filter(camera, layout, filtered);
        seen = expected;
        device.filter(camera, layout, seen);
        EXPECT_EQ(filtered.record.run_total, seen.record.run_total);
        EXPECT_EQ(filtered.record.raw_run_total, seen.record.raw_run_total);
        EXPECT_TRUE(all_close(filtered.runs, seen.runs));
        EXPECT_LE(compare_bytes(filtered.alpha, seen.alpha).share(), 0.001);
        EXPECT_FALSE(equal(filtered.alpha, expected.alpha)) << "nothing was changed";

        seen = expected;
        reference.density(camera, layout, expected);
        device.density(camera, layout, seen);
        EXPECT_TRUE(equal(expected.flags, seen.flags));
        EXPECT_TRUE(all_close(expected.weights, seen.weights));
    }

    gl::HeadlessContext context_;
};

TEST_P(StagesTest, Clevis) {
    compare_scene("clevis");
}
TEST_P(StagesTest, House) {
    compare_scene("house");
}
TEST_P(StagesTest, Ship) {
    compare_scene("ship");
}
TEST_P(StagesTest, Office) {
    compare_scene("office");
}

TEST_P(StagesTest, NoSegmentsAtAll) {
    LineSet nothing;
    Stages device{GetParam().backend(), nothing};
    const Camera camera = make_camera({.near = 1, .far = 2}, {64, 48}, {});
    FrameState state;
    device.pyramid(camera, std::vector<float>(64 * 48 * 4, 1.0F), state);
    device.project(camera, true, state);
    device.scan(state);
    EXPECT_TRUE(equal(state.offsets, {0}));
    const AtlasLayout layout = make_atlas_layout(AtlasLayoutKind::wrap, 100, 4096);
    device.atlas(camera, std::vector<float>(64 * 48 * 4, 1.0F), layout, state);
    device.compact(camera, layout, state);
    EXPECT_EQ(state.record.run_total, 0U);
    EXPECT_EQ(state.record.points[0], 0U);
    device.intervals(camera, std::vector<float>(64 * 48 * 4, 1.0F), layout, true, state);
    EXPECT_TRUE(state.intervals.empty());
    device.halo(camera, state);
    device.density(camera, layout, state);
    EXPECT_TRUE(equal(state.weights, std::vector<float>(state.weights.size(), 1.0F)));
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(StagesTest);
INSTANTIATE_TEST_SUITE_P(OnDevice, StagesTest, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lineatlas::test
