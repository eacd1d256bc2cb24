// Silhouettes of whole models in chains. Those of closed bodies are loops, and the tables of a
// frame come back in the order of the line set.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "compare.hpp"
#include "compute/cpp/cpp_device.hpp"
#include "compute/stages/silhouette_chains.hpp"
#include "devices.hpp"
#include "lineatlas/visibility.hpp"
#include "test_meshes.hpp"
#include "visibility/line_tables.hpp"
#include "visibility/table_order.hpp"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// Without creases, so that all edges of a body are candidates.
const LineOptions smooth{.crease = pi, .silhouettes = Silhouettes::mesh};

/// A closed surface of revolution about y with `sides` corners in a row. profile: (radius, height)
/// of the rows. The first and the last radius are 0, or with `ring` the last row joins the first.
Mesh revolved(const std::vector<glm::vec2>& profile, std::uint32_t sides, bool ring) {
    Mesh mesh;
    const auto rows = static_cast<std::uint32_t>(profile.size());
    for (const glm::vec2 place : profile) {
        for (std::uint32_t k = 0; k < sides; ++k) {
            const float angle = 2 * pi * static_cast<float>(k) / static_cast<float>(sides);
            mesh.positions.emplace_back(place.x * std::cos(angle), place.y,
                                        place.x * std::sin(angle));
        }
    }
    for (std::uint32_t r = 0; r + (ring ? 0 : 1) < rows; ++r) {
        const std::uint32_t low = r * sides, high = (r + 1) % rows * sides;
        for (std::uint32_t k = 0; k < sides; ++k) {
            const std::uint32_t next = (k + 1) % sides;
            mesh.triangles.emplace_back(low + k, high + k, low + next);
            mesh.triangles.emplace_back(low + next, high + k, high + next);
        }
    }
    return mesh;
}

Mesh torus() {
    std::vector<glm::vec2> profile;
    for (int i = 0; i < 48; ++i) {
        const float angle = 2 * pi * static_cast<float>(i) / 48;
        profile.emplace_back(2 + 0.6F * std::cos(angle), 0.6F * std::sin(angle));
    }
    return revolved(profile, 96, true);
}

Mesh capsule() {
    std::vector<glm::vec2> profile;
    for (int i = 0; i <= 48; ++i) {
        const float angle = pi * (static_cast<float>(i) / 48 - 0.5F);
        const bool pole = i == 0 || i == 48;
        profile.emplace_back(pole ? 0 : std::cos(angle), std::sin(angle) + (i <= 24 ? -1.F : 1.F));
        if (i == 24) profile.emplace_back(1, 1);
    }
    return revolved(profile, 96, false);
}

struct Loop {
    bool closed;
    double length; ///< in space
};

/// The chains that kernels make of a line set's silhouettes, longest first.
std::vector<Loop> chains_of(const LineSet& lines, glm::vec4 eye) {
    DeviceStages on{compute::make_cpp_device()};
    const LineTables tables = upload_lines(*on.device, lines);
    const auto triangles = static_cast<std::uint32_t>(lines.triangles.size());
    const LineTables::Chunk& chunk = tables.chunks[0];
    const compute::SegmentTable table{*tables.vertices, *tables.triangles, *chunk.segments,
                                      triangles,        chunk.range.count, chunk.candidates()};
    compute::SilhouetteChains chains{on.stages, compute::SilhouetteChains::Contours::on_surface};
    const compute::SegmentTable found = chains.table_of(
        table, true, {eye, true}, [](const char*, const auto& action) { action(); });
    std::vector<Loop> loops;
    for (const Segment& segment :
         read_back<Segment>(*on.device, found.segments, found.segment_count)) {
        if ((segment.tag & LA_TAG_KIND_MASK) != LA_KIND_SILHOUETTE) continue;
        if (segment.from_start == 0) loops.push_back({(segment.tag & LA_TAG_CLOSED) != 0, 0});
        loops.back().length += glm::distance(lines.vertices[segment.p], lines.vertices[segment.q]);
    }
    std::ranges::sort(loops, std::ranges::greater{}, &Loop::length);
    return loops;
}

/// Outlines of meshes zigzag about the true ones, so they are slightly longer.
void expect_outline(const Loop& loop, double length, double most_longer) {
    EXPECT_TRUE(loop.closed);
    EXPECT_GT(loop.length, 0.98 * length);
    EXPECT_LT(loop.length, most_longer * length);
}

TEST(SilhouetteChains, OfAClosedBodyAreClosed) {
    Random random{61};
    // No two triangles lie in one plane. The edge between two such triangles is no candidate, and
    // if they are seen edge on, one may be taken for a front and the other for a back.
    for (const Mesh& body : {sphere(3), with_random_radii(sphere(3), random, 0.5F),
                             with_random_radii(torus(), random, 0.99F)}) {
        const LineSet lines = extract_lines(body, smooth);
        for (int view = 0; view < 20; ++view) {
            const glm::vec4 eye{random.direction() * 8.0F, view % 2};
            const std::vector<Loop> loops = chains_of(lines, eye);
            EXPECT_FALSE(loops.empty());
            for (const Loop& loop : loops) EXPECT_TRUE(loop.closed) << "view " << view;
        }
    }
}

TEST(SilhouetteChains, OfASphereAreOneCircle) {
    const LineSet lines = extract_lines(sphere(5), smooth);
    Random random{62};
    for (int view = 0; view < 20; ++view) {
        const std::vector<Loop> loops = chains_of(lines, {random.direction(), 0});
        expect_outline(loops[0], 2 * std::numbers::pi, 1.6);
        if (loops.size() > 1) {
            EXPECT_LT(loops[1].length, 0.3) << "beside crumbs of the zigzag";
        }
    }
}

TEST(SilhouetteChains, OfATorusFromAboveAreTwoCircles) {
    const LineSet lines = extract_lines(torus(), smooth);
    const std::vector<Loop> loops = chains_of(lines, {0, 1, 0, 0});
    ASSERT_EQ(loops.size(), 2U);
    expect_outline(loops[0], 2 * std::numbers::pi * 2.6, 1.001);
    expect_outline(loops[1], 2 * std::numbers::pi * 1.4, 1.001);
}

TEST(SilhouetteChains, OfACapsuleFromTheSideAreOneStadium) {
    const std::vector<Loop> loops = chains_of(extract_lines(capsule(), smooth), {0.7F, 0, 0.4F, 0});
    ASSERT_EQ(loops.size(), 1U);
    expect_outline(loops[0], 2 * std::numbers::pi + 4, 1.001);
}

/// A cylinder has two silhouettes between its rims; each is a line by itself.
TEST(SilhouetteChains, OfACylinderAreTwoLines) {
    const std::vector<Loop> loops = chains_of(extract_lines(cylinder(64, true)), {5, 1, 0, 1});
    ASSERT_EQ(loops.size(), 2U);
    for (const Loop& loop : loops) {
        EXPECT_FALSE(loop.closed);
        EXPECT_NEAR(loop.length, 2, 1e-5);
    }
}

TEST(SilhouetteChains, OfAWallSeenEdgeOnAreAtItsNearBorder) {
    // A round wall between two cones, with the roughness of rounding, in a view along the wall.
    Random random{63};
    constexpr std::uint32_t sides = 48;
    Mesh body = revolved({{0, -1.2F}, {0.5F, -1.1F}, {1, -1}, {1, 1}, {0.5F, 1.1F}, {0, 1.2F}},
                         sides, false);
    for (glm::vec3& p : body.positions) {
        const float rough = 1 + random.between(-3e-7F, 3e-7F);
        p.x *= rough;
        p.z *= rough;
    }
    const LineSet lines = extract_lines(body, smooth);
    Camera camera;
    camera.size = {300, 300};
    camera.view = glm::lookAt(glm::vec3{0, 5, 0}, glm::vec3{0}, glm::vec3{0, 0, 1});
    camera.projection = glm::ortho(-1.2F, 1.2F, -1.2F, 1.2F, 0.1F, 8.0F);
    double near = 0;
    for (const Interval& interval : LineVisibility{lines}.find(camera)) {
        const auto place = [](const float* v) { return glm::dvec3{v[0], v[1], v[2]}; };
        if (interval.start_world[1] > 0)
            near += glm::distance(place(interval.start_world), place(interval.end_world));
    }
    const double around = 2 * sides * std::sin(std::numbers::pi / sides);
    EXPECT_NEAR(near, around, 1e-3 * around);
}

TEST(SilhouetteChains, IntervalsComeBackInTheOrderOfTheLineSet) {
    const LineSet lines = extract_lines(sphere(4), smooth);
    Camera camera; // parallel, because then shares of a segment are the same in space and on the
                   // screen
    camera.size = {300, 300};
    camera.view = glm::lookAt(glm::vec3{2, 1, 3}, glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = glm::ortho(-1.2F, 1.2F, -1.2F, 1.2F, 0.1F, 8.0F);
    const std::vector<Interval> found = LineVisibility{lines}.find(camera, {.hidden = true});
    ASSERT_GT(found.size(), 40U);
    EXPECT_TRUE(std::ranges::is_sorted(found, {}, &Interval::segment));
    const auto place = [](const float* v) { return glm::vec3{v[0], v[1], v[2]}; };
    std::map<std::uint32_t, float> end_of;
    int joined = 0;
    for (const Interval& interval : found) {
        const Segment& segment = lines.segments[interval.segment];
        const glm::vec3 p = lines.vertices[segment.p], q = lines.vertices[segment.q];
        EXPECT_LT(glm::distance(place(interval.start_world), glm::mix(p, q, interval.start_sample)),
                  1e-4F);
        EXPECT_LT(glm::distance(place(interval.end_world), glm::mix(p, q, interval.end_sample)),
                  1e-4F);
        EXPECT_LT(interval.start_sample, interval.end_sample);
        EXPECT_LT(interval.start_arc, interval.end_arc);
        const auto before = end_of.find(interval.segment);
        if (before != end_of.end()) {
            EXPECT_LE(before->second, interval.start_sample);
        }
        end_of[interval.segment] = interval.end_sample;
        joined += (interval.flags >> LA_INTERVAL_END_SHIFT & LA_END_MASK) == LA_END_JOIN ? 1 : 0;
    }
    EXPECT_GT(joined, 20) << "edges of an outline go on in each other";
}

TEST(SilhouetteChains, OrderOfAFrameIsTakenBack) {
    // A line, then candidates 2 reversed, 0 and 1 reversed.
    const TableOrder order{.first = 1, .origins = {6, 1, 4}};
    std::vector<std::uint32_t> offsets{0, 1, 3, 3, 5};
    std::vector<std::uint8_t> samples{9, 20, 21, 10, 11};
    order.restore(5, offsets, samples);
    EXPECT_EQ(offsets, (std::vector<std::uint32_t>{0, 1, 1, 3, 5, 5}));
    EXPECT_EQ(samples, (std::vector<std::uint8_t>{9, 11, 10, 21, 20}));

    lineatlas::Run run{};
    run.segment = 3;
    run.samples = 4;
    run.start_sample = 1;
    run.end_sample = 4;
    run.start_arc = -7;
    run.end_arc = -1;
    run.start[0] = 5;
    run.end_corner[1] = 2;
    run.flags = LA_END_HIDDEN << LA_RUN_START_SHIFT | LA_END_JOIN << LA_RUN_END_SHIFT;
    std::vector<lineatlas::Run> runs{run};
    order.restore(runs);
    EXPECT_EQ(runs[0].segment, 2U);
    EXPECT_EQ(runs[0].start_sample, 0);
    EXPECT_EQ(runs[0].end_sample, 3);
    EXPECT_EQ(runs[0].start_arc, 1);
    EXPECT_EQ(runs[0].end_arc, 7);
    EXPECT_EQ(runs[0].end[0], 5);
    EXPECT_EQ(runs[0].start_corner[1], -2);
    EXPECT_EQ(runs[0].flags, LA_END_JOIN << LA_RUN_START_SHIFT | LA_END_HIDDEN << LA_RUN_END_SHIFT);
}

} // namespace
} // namespace lineatlas::test
