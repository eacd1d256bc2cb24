// Batches of segments and triangles. Segments dropped by batches are hidden, and paths that go on
// beyond a hidden batch stay.

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "compute/stages/batches.hpp"
#include "core/contact.hpp"
#include "lineatlas/scenes.hpp"
#include "stage_test.hpp"
#include "visibility/exact_lines.hpp"
#include "visibility/line_tables.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::vec2 viewport{200, 100};
constexpr glm::ivec2 tile_count{13, 7};
/// Depths of walls before and behind lines at depth 0.5.
constexpr float before = 0.49F, behind = 1;

/// A path of steps of one pixel along the middle of the picture, at depth 0.5.
struct Path {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles{{0, 1, 2}};
    std::vector<Segment> segments;

    Path(float first_pixel, std::uint32_t steps, std::uint32_t tag = LA_KIND_CREASE) {
        for (std::uint32_t i = 0; i <= steps; ++i)
            vertices.emplace_back((first_pixel + static_cast<float>(i)) / 100 - 1, 0.12F, 0);
        for (std::uint32_t i = 0; i < steps; ++i)
            segments.push_back({i, i + 1, LA_NO_FACE, LA_NO_FACE, i, steps - 1 - i, 0, tag});
    }
};

struct Projected {
    std::vector<std::uint32_t> counts, arcs;
    std::vector<std::uint8_t> states;
};

class BatchesTest : public StageTest {
  protected:
    /// tiles: of the pyramid, 13 by 7. by_batches: false projects segments alone.
    Projected project(const Path& path, std::vector<float> tiles, bool by_batches,
                      bool drops_hidden = true) {
        const auto n = static_cast<std::uint32_t>(path.segments.size());
        const auto vertices = put(path.vertices);
        const auto triangles = put(path.triangles);
        const auto segments = put(path.segments);
        const auto front = put(std::vector<std::uint8_t>(2));
        const auto pyramid = put(tiles);
        const auto clipped = put(std::vector<ClippedSegment>(n));
        const auto counts = put(std::vector<std::uint32_t>(n, 77));
        const auto arcs = put(std::vector<std::uint32_t>(n, 77));
        const auto boxes = put(std::vector<compute::Batch>(n / LA_BATCH + 1));
        const auto states = put(std::vector<std::uint8_t>(n / LA_BATCH + 1, 77));
        const compute::BatchTable batches{boxes.get(), states.get(), n};
        const compute::SegmentTable table{*vertices, *triangles, *segments, 1, n};
        const compute::OcclusionTest occlusion{
            .tiles = *pyramid, .tile_count = tile_count, .depth_scale = 1, .tolerance = 0};
        const compute::ProjectClipArgs args{.table = table,
                                            .front = *front,
                                            .clip_from_world = glm::mat4{1},
                                            .viewport = viewport,
                                            .step = 2,
                                            .kind_mask = all_line_kinds,
                                            .occlusion = &occlusion,
                                            .out = {*clipped, *counts, *arcs},
                                            .batches =
                                                by_batches ? batches : compute::BatchTable{}};
        if (by_batches) {
            stages().launch<compute::kernels::project_clip_boxes>(batches.batch_count(), {n}, table,
                                                                  batches);
            stages().project_clip_batches(args, drops_hidden);
        }
        stages().project_clip(args);
        return {get<std::uint32_t>(*counts, n), get<std::uint32_t>(*arcs, n),
                get<std::uint8_t>(*states, batches.batch_count())};
    }
    /// Tiles that hide everything left of a tile.
    static std::vector<float> open_from(int tile) {
        std::vector<float> tiles;
        for (int i = 0; i < tile_count.x * tile_count.y; ++i)
            tiles.push_back(i % tile_count.x < tile ? before : behind);
        return tiles;
    }
};
INSTANTIATE_TEST_SUITE_P(OnDevice, BatchesTest, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

TEST_P(BatchesTest, WhatIsOutsideIsLeftOutAndNothingElse) {
    // The first batch ends 6 pixels outside, the last one within.
    const Path path{-70, 4 * LA_BATCH};
    const Projected one = project(path, open_from(0), false),
                    seen = project(path, open_from(0), true);
    EXPECT_TRUE(
        equal(seen.states, {LA_BATCH_OUTSIDE, LA_BATCH_SEEN, LA_BATCH_SEEN, LA_BATCH_SEEN}));
    EXPECT_TRUE(equal(seen.counts, one.counts));
    EXPECT_TRUE(equal(seen.arcs, one.arcs));
    EXPECT_EQ(std::ranges::count(one.arcs, 0U), 70);
}

TEST_P(BatchesTest, AHiddenBatchKeepsWhatGoesOnBeyondIt) {
    // The path goes from pixel 20 to 84 and on to 120, behind a wall up to pixel 96.
    const std::uint32_t steps = LA_BATCH + 36;
    for (const bool closed : {false, true}) {
        const Path path{20, steps, closed ? LA_KIND_CREASE | LA_TAG_CLOSED : LA_KIND_CREASE};
        const Projected seen = project(path, open_from(6), true);
        EXPECT_TRUE(equal(seen.states, {LA_BATCH_HIDDEN, LA_BATCH_SEEN}));
        for (std::uint32_t i = 0; i < steps; ++i) {
            const bool kept = i >= LA_BATCH - 1 || (closed && i == 0);
            EXPECT_NEAR(seen.arcs[i], kept ? 256 : 0, 1) << i;
        }
        EXPECT_TRUE(equal(seen.counts, project(path, open_from(6), false).counts));
        const Projected measured = project(path, open_from(6), true, false);
        EXPECT_TRUE(equal(measured.arcs, project(path, open_from(6), false).arcs));
        EXPECT_EQ(std::ranges::count(measured.arcs, 0U), 0);
    }
}

TEST_P(BatchesTest, OneTileInReachOrAFaceThatComesNearerShowsAll) {
    // Probes reach 1.5 pixels, and one more pixel is spared.
    EXPECT_EQ(project({29, LA_BATCH}, open_from(6), true).states[0], LA_BATCH_HIDDEN);
    EXPECT_EQ(project({30, LA_BATCH}, open_from(6), true).states[0], LA_BATCH_SEEN);
    Path path{20, LA_BATCH};
    path.vertices.emplace_back(-0.5F, 0.2F, -0.03F); // to depth 0.485
    path.triangles = {{0, 1, LA_BATCH + 1}};
    path.segments[7].face_b = 0 | LA_FACE_FLIPPED;
    EXPECT_EQ(project(path, open_from(6), true).states[0], LA_BATCH_SEEN);
}

TEST_P(BatchesTest, BoxesAreMadeWhereTheModelStandsStill) {
    const Path path{20, LA_BATCH};
    const auto vertices = put(path.vertices), other = put(path.vertices);
    const auto triangles = put(path.triangles);
    const auto segments = put(path.segments);
    compute::SegmentTable table{*vertices, *triangles, *segments, 1, LA_BATCH};
    compute::Batches batches{stages()};
    EXPECT_FALSE(batches.has_segments(table));
    EXPECT_TRUE(batches.has_segments(table));
    EXPECT_TRUE(batches.has_segments(table));
    ++table.version;
    EXPECT_FALSE(batches.has_segments(table));
    EXPECT_TRUE(batches.has_segments(table));
    batches.forget();
    EXPECT_FALSE(batches.has_segments(table));
    const auto box = get<compute::Batch>(*batches.table().batches, 1)[0];
    EXPECT_NEAR(box.low[0], -0.8, 1e-6);
    EXPECT_NEAR(box.high[0], -0.16, 1e-6);
}

/// The results of the exact method in frames of one model.
class ExactBatches : public StageTest {
  protected:
    struct Found {
        std::vector<std::uint32_t> offsets;
        std::vector<float> spans;
        std::uint32_t length; ///< the length of all lines
    };
    std::vector<Found> find(const LineSet& lines, const Camera& camera, std::size_t frames,
                            bool measured) {
        const LineTables tables = upload_lines(stages().device(), lines);
        const auto triangles = static_cast<std::uint32_t>(lines.triangles.size());
        const LineTables::Chunk& chunk = tables.chunks[0];
        const compute::SegmentTable table{*tables.vertices, *tables.triangles, *chunk.segments,
                                          triangles,        chunk.range.count, chunk.candidates()};
        ExactLines exact{stages()};
        exact.make_tables(chunk.range.count);
        const LineView view{.camera = camera,
                            .bounds = lines.bounds,
                            .contact = contact_of(lines),
                            .lines = all_line_kinds,
                            .step = 2,
                            .measured = measured};
        std::vector<Found> result(frames);
        for (Found& found : result) {
            exact.find(
                view, 1, ProgressPart::none(), [&](std::size_t) { return table; },
                [](const char*, const auto& run) { run(); },
                [&](std::size_t, const compute::SegmentTable& segments,
                    const compute::SpanTable& spans) {
                    const std::size_t n = segments.segment_count;
                    found.offsets = get<std::uint32_t>(spans.span_offsets, n + 1);
                    found.spans = get<float>(spans.spans, 2 * std::size_t{found.offsets[n]});
                    found.length = get<std::uint32_t>(exact.clipped().arcs, n + 1)[n];
                });
        }
        return result;
    }
};
INSTANTIATE_TEST_SUITE_P(OnDevice, ExactBatches, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

/// Faces before a path with steps of one pixel, both given in pixels. Tiles are 64 pixels wide.
LineSet path_behind(std::vector<glm::vec2> corners, glm::vec2 start) {
    Mesh mesh;
    for (const glm::vec2 corner : corners) mesh.positions.emplace_back(corner, 10);
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.polylines.emplace_back();
    for (std::uint32_t i = 0; i <= LA_BATCH; ++i) {
        mesh.polylines[0].push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.emplace_back(start.x + static_cast<float>(i), start.y, -10);
    }
    return extract_lines(mesh, {.lines = mask_of(LineKind::file)});
}

Camera straight_camera() {
    Camera camera;
    camera.size = {256, 256};
    camera.view = glm::translate(glm::mat4{1}, {0, 0, -1000});
    camera.projection = glm::ortho(0.0F, 256.0F, 0.0F, 256.0F, 1.0F, 2000.0F);
    return camera;
}

TEST_P(ExactBatches, AreHiddenWhereBothHalvesOfAQuadCoverTheirTiles) {
    const std::vector<glm::vec2> wall{{-9, -9}, {140, -9}, {140, 300}, {-9, 300}};
    // The diagonal crosses the first path; the second goes on beyond the wall.
    const LineSet hidden = path_behind(wall, {20, 100}), shown = path_behind(wall, {100, 100});
    const auto nothing = find(hidden, straight_camera(), 2, false);
    EXPECT_NEAR(nothing[0].length, 256 * LA_BATCH, LA_BATCH);
    EXPECT_EQ(nothing[1].length, 0U);
    EXPECT_TRUE(nothing[1].spans.empty());
    const auto some = find(shown, straight_camera(), 2, false);
    EXPECT_EQ(some[1].length, some[0].length);
    EXPECT_TRUE(equal(some[1].spans, some[0].spans));
    EXPECT_EQ(some[1].offsets.back(), 24U); // steps from pixel 140 to 164
}

TEST_P(ExactBatches, AreSeenBesideAQuadThatHasAGap) {
    // The second half only partly reaches the upper left of the diagonal.
    const std::vector<glm::vec2> wall{{-9, -9}, {300, -9}, {300, 300}, {100, 160}};
    const auto found = find(path_behind(wall, {10, 200}), straight_camera(), 2, false);
    EXPECT_EQ(found[1].offsets.back(), LA_BATCH);
    EXPECT_EQ(found[1].length, found[0].length);
}

TEST_P(ExactBatches, FindTheSameSpansOfAWalledHouse) {
    if (GetParam().slow) GTEST_SKIP();
    const Scene house = make_scene("house");
    Mesh mesh = house.mesh;
    const View view = house.view(0.1F);
    // A wall before the right half of it: two faces, whose diagonal crosses the picture.
    const glm::vec3 forward = view.target - view.eye;
    const float size = glm::length(forward);
    const glm::vec3 right = size * glm::normalize(glm::cross(forward, view.up));
    const glm::vec3 up = size * glm::normalize(glm::cross(right, forward));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const glm::vec3 centre = view.eye + 0.3F * forward;
    mesh.positions.insert(mesh.positions.end(),
                          {centre - up, centre + right - up, centre + right + up, centre + up});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
    if (!mesh.groups.empty()) mesh.triangle_group.resize(mesh.triangles.size());
    const LineSet lines = extract_lines(mesh);
    for (const bool near : {false, true}) { // near: much of the model is outside
        View moved = view;
        if (near) moved.eye += 0.15F * forward;
        const Camera camera = make_camera(moved, {400, 300}, lines.bounds);
        const auto measured = find(lines, camera, 2, true);
        const auto plain = find(lines, camera, 2, false);
        EXPECT_GT(measured[0].spans.size(), 100U);
        for (const Found& found : {measured[1], plain[0], plain[1]}) {
            EXPECT_TRUE(equal(found.offsets, measured[0].offsets));
            EXPECT_TRUE(equal(found.spans, measured[0].spans));
        }
        EXPECT_EQ(measured[1].length, measured[0].length);
        EXPECT_EQ(plain[0].length, measured[0].length) << "there are no boxes yet";
        if (near) continue; // nearly no batch is entirely behind the wall
        EXPECT_LT(plain[1].length, measured[0].length) << "nothing is hidden whole";
    }
}

} // namespace
} // namespace lineatlas::test
