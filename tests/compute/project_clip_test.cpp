// project_clip: lines with known clipped ends, lengths, sample counts and own faces.

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>

#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::vec2 viewport{200, 100};
constexpr float step = 2;

/// Looks along -z with planes at 1 and 3 and 90 degrees. The window has x and y divided by -z, and
/// depth 1.5 + 1.5 / z.
const glm::mat4 perspective{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -2, -1}, {0, 0, -3, 0}};

struct Model {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles{};
    std::vector<Segment> segments{};

    /// A segment between the last two vertices.
    Segment& add(glm::vec3 p, glm::vec3 q, std::uint32_t tag = LA_KIND_CREASE) {
        vertices.insert(vertices.end(), {p, q});
        const auto count = static_cast<std::uint32_t>(vertices.size());
        segments.push_back({count - 2, count - 1, LA_NO_FACE, LA_NO_FACE, 0, 0, 0, tag});
        return segments.back();
    }
    /// Adds a triangle at the last segment, with its corners in another order each time.
    std::uint32_t add_face(glm::vec3 corner) {
        vertices.push_back(corner);
        const auto count = static_cast<std::uint32_t>(triangles.size());
        const Segment& segment = segments.back();
        const auto third = static_cast<std::uint32_t>(vertices.size() - 1);
        const glm::uvec3 orders[] = {{segment.q, third, segment.p},
                                     {third, segment.p, segment.q},
                                     {segment.p, segment.q, third}};
        triangles.push_back(orders[count % 3]);
        return count;
    }
};

struct Projected {
    std::vector<std::uint32_t> counts, arcs;
    std::vector<ClippedSegment> clipped;
};

struct Options {
    glm::mat4 clip_from_world{1};
    std::uint32_t kind_mask = ~0U;
    std::vector<std::uint8_t> front{};
    std::vector<float> tiles{}; ///< 13 by 7, of 16 texels, a texel per pixel; empty: nothing hides
    float tolerance = 0;
    bool keep_clipped = false;
};

class ProjectClipStage : public StageTest {
  protected:
    Projected project(const Model& model, Options options = {}) {
        const auto n = static_cast<std::uint32_t>(model.segments.size());
        const auto triangle_count = static_cast<std::uint32_t>(model.triangles.size());
        options.front.resize(triangle_count + 1);
        const auto vertices = put(model.vertices);
        const auto triangles = put(model.triangles);
        const auto segments = put(model.segments);
        const auto front = put(options.front);
        const auto tiles = put(options.tiles);
        const auto clipped = put(std::vector<ClippedSegment>(n));
        const auto counts = put(std::vector<std::uint32_t>(n, 77));
        const auto arcs = put(std::vector<std::uint32_t>(n, 77));
        const compute::OcclusionTest occlusion{.tiles = *tiles,
                                               .tile_count = {13, 7},
                                               .depth_scale = 1,
                                               .tolerance = options.tolerance,
                                               .keep_clipped = options.keep_clipped};
        stages().project_clip({.table = {*vertices, *triangles, *segments, triangle_count, n},
                               .front = *front,
                               .clip_from_world = options.clip_from_world,
                               .viewport = viewport,
                               .step = step,
                               .kind_mask = options.kind_mask,
                               .occlusion = options.tiles.empty() ? nullptr : &occlusion,
                               .out = {*clipped, *counts, *arcs}});
        return {.counts = get<std::uint32_t>(*counts, n),
                .arcs = get<std::uint32_t>(*arcs, n),
                .clipped = get<ClippedSegment>(*clipped, n)};
    }
};
INSTANTIATE_TEST_SUITE_P(OnDevice, ProjectClipStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

void expect_ends(const ClippedSegment& clipped, glm::vec4 p, glm::vec4 q, float t0, float t1) {
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(clipped.p[i], p[i], 1e-5) << i;
        EXPECT_NEAR(clipped.q[i], q[i], 1e-5) << i;
    }
    EXPECT_NEAR(clipped.t0, t0, 1e-6);
    EXPECT_NEAR(clipped.t1, t1, 1e-6);
}

TEST_P(ProjectClipStage, SamplesAreTheLengthInPixelsOverTheStepRoundedUp) {
    Model model;
    model.add({-0.5F, 0, 0}, {0.5F, 0, 0});        // 100 pixels
    model.add({-0.5F, 0, 0}, {0.51F, 0, 0});       // 101
    model.add({0, -0.5F, 0.1F}, {0, 0.25F, 0.3F}); // 37.5, upright
    model.add({-0.3F, -0.4F, 0}, {0.3F, 0.4F, 0}); // 60 by 40
    const Projected seen = project(model);
    EXPECT_TRUE(equal(seen.counts, {50, 51, 19, 37}));
    EXPECT_EQ(seen.arcs[0], 25'600U);
    EXPECT_NEAR(seen.arcs[1], 25'856, 1);
    EXPECT_EQ(seen.arcs[2], 9600U);
    EXPECT_NEAR(seen.arcs[3], 256 * std::hypot(60, 40), 1);
    expect_ends(seen.clipped[2], {0, -0.5F, 0.1F, 1}, {0, 0.25F, 0.3F, 1}, 0, 1);
}

TEST_P(ProjectClipStage, EveryPlaneOfTheFrustumClips) {
    Model model;
    model.add({-2, 0, 0}, {0.5F, 0, 0});
    model.add({0.5F, 0, 0}, {3, 0, 0});
    model.add({0, -3, 0}, {0, 0.5F, 0});
    model.add({0, 0.5F, 0}, {0, 1.5F, 0});
    model.add({0, 0, -3}, {0.5F, 0, 0});
    model.add({0, 0, 0}, {0.5F, 0, 2});
    model.add({-1.4F, 0.9F, 0}, {-0.9F, 1.4F, 0}); // past the corner
    model.add({-3, 0, 0}, {3, 0, 0});
    const Projected seen = project(model);
    expect_ends(seen.clipped[0], {-1, 0, 0, 1}, {0.5F, 0, 0, 1}, 0.4F, 1);
    expect_ends(seen.clipped[1], {0.5F, 0, 0, 1}, {1, 0, 0, 1}, 0, 0.2F);
    expect_ends(seen.clipped[2], {0, -1, 0, 1}, {0, 0.5F, 0, 1}, 4.0F / 7, 1);
    expect_ends(seen.clipped[3], {0, 0.5F, 0, 1}, {0, 1, 0, 1}, 0, 0.5F);
    expect_ends(seen.clipped[4], {1.0F / 3, 0, -1, 1}, {0.5F, 0, 0, 1}, 2.0F / 3, 1);
    expect_ends(seen.clipped[5], {0, 0, 0, 1}, {0.25F, 0, 1, 1}, 0, 0.5F);
    expect_ends(seen.clipped[7], {-1, 0, 0, 1}, {1, 0, 0, 1}, 1.0F / 3, 2.0F / 3);
    EXPECT_EQ(seen.counts[6], 0U);
    EXPECT_EQ(seen.arcs[6], 0U);
    EXPECT_EQ(seen.counts[7], 100U);
}

TEST_P(ProjectClipStage, WhatPassesTheEyeIsCutAtTheNearPlane) {
    Model model;
    model.add({0.5F, 0, -2}, {0.5F, 0, 2});        // from pixel 125 to 150
    model.add({0.5F, 0.25F, 1}, {0.5F, 0.25F, 2}); // behind the eye
    const Projected seen = project(model, {.clip_from_world = perspective});
    expect_ends(seen.clipped[0], {0.5F, 0, 1, 2}, {0.5F, 0, -1, 1}, 0, 0.25F);
    EXPECT_TRUE(equal(seen.counts, {13, 0}));
    EXPECT_EQ(seen.arcs[0], 6400U);
}

TEST_P(ProjectClipStage, KindsThatAreNotAskedForHaveNoSamples) {
    Model model;
    for (const std::uint32_t kind : {LA_KIND_CREASE, LA_KIND_BOUNDARY, LA_KIND_FILE}) {
        model.add({-0.5F, 0, 0}, {0.5F, 0, 0}, kind);
    }
    const Projected seen = project(model, {.kind_mask = 1U << LA_KIND_BOUNDARY});
    EXPECT_TRUE(equal(seen.counts, {0, 50, 0}));
    EXPECT_TRUE(equal(seen.arcs, {0, 25'600, 0}));
}

TEST_P(ProjectClipStage, SilhouettesLieBetweenAFrontAndABack) {
    Model model;
    for (const std::uint32_t flipped : {0U, LA_FACE_FLIPPED}) {
        for (int second = 0; second < 2; ++second) {
            Segment& segment = model.add({-0.5F, 0, 0}, {0.5F, 0, 0}, LA_KIND_SILHOUETTE);
            segment.face_a = 0;
            segment.face_b = (second == 0 ? 1U : 2U) | flipped;
        }
    }
    model.triangles.assign(3, {0, 1, 2});
    const Projected seen = project(model, {.front = {1, 1, 0}});
    EXPECT_TRUE(equal(seen.counts, {0, 50, 50, 0}));
}

TEST_P(ProjectClipStage, OnlyLoneSegmentsVanishBelowAStep) {
    Model model;
    model.add({0, 0, 0}, {0.015F, 0, 0}, LA_KIND_CREASE | LA_TAG_LONE); // 1.5 pixels
    model.add({0, 0, 0}, {0.015F, 0, 0});
    model.add({0, 0, 0}, {0.025F, 0, 0}, LA_KIND_CREASE | LA_TAG_LONE); // 2.5
    model.add({0, 0, 0}, {0, 0, 0.5F});                                 // end on
    const Projected seen = project(model);
    EXPECT_TRUE(equal(seen.counts, {0, 1, 2, 1}));
    EXPECT_EQ(seen.arcs[0], 0U);
    EXPECT_NEAR(seen.arcs[1], 384, 1);
    EXPECT_EQ(seen.arcs[3], 1U) << "never none: it is drawn";
}

/// Upper halves of floats keep seven bits.
void expect_face(std::uint32_t packed, double slope, double height) {
    EXPECT_NEAR(slope_of(packed), slope, 0.008 * std::fabs(slope));
    EXPECT_NEAR(height_of(packed), height, 0.008 * std::fabs(height));
}

TEST_P(ProjectClipStage, OwnFacesAreSlopeAcrossAndHeightOfTheThirdCorner) {
    Model model;
    Segment& up = model.add({-0.5F, 0, 0}, {0.5F, 0, 0});
    up.face_a = model.add_face({0, 0.4F, 0.2F}); // 20 pixels up, 0.1 deeper
    model.segments.back().face_b = model.add_face({0.7F, -0.6F, -0.1F}) | LA_FACE_FLIPPED;
    Segment& edge_on = model.add({-0.5F, 0, 0}, {0.5F, 0, 0}); // to the eye; no second face
    edge_on.face_a = model.add_face({0, 0, 0.5F});
    const Projected seen = project(model);
    expect_face(seen.clipped[0].own_a, 0.1 / 20, 20);
    expect_face(seen.clipped[0].own_b, 0.05 / 30, -30); // 30 down, 0.05 nearer
    EXPECT_EQ(seen.clipped[1].own_b, 0U);
}

glm::dvec3 window_of(const glm::mat4& clip_from_world, const glm::dvec3& point) {
    const glm::dvec4 c = glm::dmat4{clip_from_world} * glm::dvec4{point, 1};
    return (glm::dvec3{c.x, c.y, c.z} / c.w + 1.0) * 0.5 * glm::dvec3{viewport.x, viewport.y, 1};
}

TEST_P(ProjectClipStage, OwnFacesInPerspectiveAreThoseOfThreePlacesInTheWindow) {
    const glm::dvec3 p{-0.9, -0.3, -1.4}, q{0.7, 0.2, -2.3};
    for (const glm::dvec3 corner : {glm::dvec3{0.3, 0.8, -1.7}, {-0.4, -0.9, -2.8}}) {
        Model model;
        model.add(p, q);
        model.segments.back().face_a = model.add_face(corner);
        const std::uint32_t packed =
            project(model, {.clip_from_world = perspective}).clipped[0].own_a;
        // Depth is a plane over the window. The equations give its change along and across the
        // line.
        const glm::dvec3 a = window_of(perspective, p), b = window_of(perspective, q),
                         c = window_of(perspective, corner);
        const glm::dvec2 along = glm::normalize(glm::dvec2{b.x - a.x, b.y - a.y});
        const glm::dvec2 way{c.x - a.x, c.y - a.y};
        const double height = along.x * way.y - along.y * way.x;
        const double depth_along = (b.z - a.z) / std::hypot(b.x - a.x, b.y - a.y);
        const double slope = (c.z - a.z - depth_along * glm::dot(along, way)) / height;
        expect_face(packed, slope, height);
    }
}

TEST_P(ProjectClipStage, AFaceThatReachesBehindTheEyeIsHighOnItsOwnSide) {
    for (const double side : {1.0, -1.0}) {
        Model model;
        model.add({-0.5F, 0, -2}, {0.5F, 0, -2});
        model.segments.back().face_a = model.add_face({0.1F, side * 0.5F, 1});
        const std::uint32_t packed =
            project(model, {.clip_from_world = perspective}).clipped[0].own_a;
        EXPECT_NEAR(height_of(packed), side * 1e5, 1e3);
    }
}

/// A line of 100 pixels at depth 0.5 through tiles 3 to 9 of row 3; `tiles` hide it or not.
class ProjectClipHidden : public ProjectClipStage {
  protected:
    Projected behind(float depth, const Options& more = {}, const Model& model = line()) {
        Options options = more;
        if (options.tiles.empty()) options.tiles.assign(13 * 7, depth);
        return project(model, options);
    }
    static Model line() {
        Model model;
        model.add({-0.5F, 0.12F, 0}, {0.5F, 0.12F, 0}); // at 56 pixels, in the middle of its row
        return model;
    }
};
INSTANTIATE_TEST_SUITE_P(OnDevice, ProjectClipHidden, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

TEST_P(ProjectClipHidden, BehindEveryTileThereAreNoSamples) {
    EXPECT_EQ(behind(0.51F).counts[0], 50U);
    const Projected hidden = behind(0.49F);
    EXPECT_EQ(hidden.counts[0], 0U);
    EXPECT_EQ(hidden.arcs[0], 25'600U) << "the texture of a path must not depend on what hides it";
    EXPECT_EQ(hidden.clipped[0].p[3], 0) << "dropped";
    const Projected kept = behind(0.49F, {.keep_clipped = true});
    EXPECT_EQ(kept.counts[0], 0U);
    expect_ends(kept.clipped[0], {-0.5F, 0.12F, 0, 1}, {0.5F, 0.12F, 0, 1}, 0, 1);
    // Neighbours on the path need the place of a hidden segment.
    Model path = line();
    path.segments[0].to_end = 1;
    EXPECT_NEAR(behind(0.49F, {}, path).clipped[0].q[0], 0.5F, 1e-6);
}

TEST_P(ProjectClipHidden, OneTileThatAProbeTouchesShowsAll) {
    for (const auto& [x, y, samples] :
         {std::tuple{5, 3, 50U}, {9, 3, 50U}, {2, 3, 0U}, {10, 3, 0U}, {5, 2, 0U}, {5, 4, 0U}}) {
        Options options;
        options.tiles.assign(13 * 7, 0.49F);
        options.tiles[static_cast<std::size_t>(y * 13 + x)] = 1;
        EXPECT_EQ(behind(0, options).counts[0], samples) << x << ", " << y;
    }
    // 1.5 texels from the next row of tiles, and a little less.
    for (const auto& [y, samples] : {std::pair{62.4F, 0U}, {62.6F, 50U}}) {
        Model model;
        model.add({-0.5F, y / 50 - 1, 0}, {0.5F, y / 50 - 1, 0});
        Options options;
        options.tiles.assign(13 * 7, 0.49F);
        for (std::size_t i = 4 * 13; i < 5 * 13; ++i) options.tiles[i] = 1;
        EXPECT_EQ(behind(0, options, model).counts[0], samples) << y;
    }
}

TEST_P(ProjectClipHidden, ToleranceOwnFacesAndSlopeCountForTheLine) {
    EXPECT_EQ(behind(0.49F, {.tolerance = 0.011F}).counts[0], 50U);
    EXPECT_EQ(behind(0.49F, {.tolerance = 0.009F}).counts[0], 0U);
    // The line's own face comes nearer by 0.005 per pixel, and probes reach 1.5 pixels.
    Model faced = line();
    faced.segments[0].face_a = faced.add_face({0, 0.52F, -0.2F});
    EXPECT_EQ(behind(0.493F, {}, faced).counts[0], 50U);
    EXPECT_EQ(behind(0.492F, {}, faced).counts[0], 0U);
    // The line gets deeper by 0.2 over 100 pixels, that is by 0.003 in 1.5 pixels. Every piece of
    // it has another depth.
    Model sloped;
    sloped.add({-0.5F, 0.12F, -0.2F}, {0.5F, 0.12F, 0.2F});
    EXPECT_EQ(behind(0.398F, {}, sloped).counts[0], 50U);
    EXPECT_EQ(behind(0.396F, {}, sloped).counts[0], 0U);
    Options rising; // behind the line at every place, but not behind the line's nearest point
    for (int i = 0; i < 13 * 7; ++i) {
        rising.tiles.push_back(0.36F + 0.032F * static_cast<float>(i % 13 - 3));
    }
    EXPECT_EQ(behind(0, rising, sloped).counts[0], 0U);
}

} // namespace
} // namespace lineatlas::test
