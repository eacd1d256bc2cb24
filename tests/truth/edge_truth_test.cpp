// The visible parts of lines, in cases known by hand.

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "core/patches.hpp"
#include "truth/edge_truth.hpp"
#include "truth_views.hpp"

namespace lineatlas {
namespace {

using test::add_block;
using test::add_panel;
using test::add_stroke;
using test::front_camera;

/// The lengths of the lines of some kinds, in pixels.
struct Lengths {
    double visible = 0, hidden = 0, undecided = 0;
};

Lengths lengths_of(const EdgeTruth& truth, LineKindMask kinds) {
    Lengths lengths;
    for (const EdgePoint& point : truth.points()) {
        const auto& segment = truth.scene().lines().segments[point.segment];
        if ((kinds >> (segment.tag & LA_TAG_KIND_MASK) & 1U) == 0) continue;
        const auto pixels = static_cast<double>(point.pixels);
        if (point.visibility == Visibility::visible) lengths.visible += pixels;
        if (point.visibility == Visibility::hidden) lengths.hidden += pixels;
        if (point.visibility == Visibility::undecided) lengths.undecided += pixels;
    }
    return lengths;
}

Lengths look(const Mesh& mesh, LineKindMask kinds, const EdgeTruthOptions& options = {}) {
    const LineSet lines = extract_lines(mesh);
    const RayScene scene{lines};
    return lengths_of(EdgeTruth{scene, front_camera(), options}, kinds);
}

constexpr LineKindMask file = mask_of(LineKind::file);
constexpr LineKindMask boundary = mask_of(LineKind::boundary);
constexpr LineKindMask silhouette = mask_of(LineKind::silhouette);

TEST(EdgeTruth, ALineBehindABoxIsHiddenWhereTheBoxIs) {
    Mesh mesh;
    add_block(mesh, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    add_stroke(mesh, {-1.503, 0.001, -1}, {1.497, 0.001, -1});
    const Lengths lengths = look(mesh, file);
    // The eye is 10 units from the origin, 9.5 from the box's front and 11 from the line.
    const double scale = 100 * 10.0 / 11;
    const double covered = 1 / 9.5 * 11 * scale;
    EXPECT_NEAR(lengths.hidden, covered, 0.5);
    EXPECT_NEAR(lengths.visible, 3 * scale - covered, 0.5);
    EXPECT_EQ(lengths.undecided, 0); // the line crosses the box's edges at a right angle
}

TEST(EdgeTruth, AThinPlateHidesHoweverNearItIs) {
    for (const float pixels : {0.3F, 0.7F, 1.0F, 1.5F}) {
        Mesh mesh;
        add_panel(mesh, {-2, -2}, {2, 2}, 0.01F * pixels);
        add_stroke(mesh, {-1, 0.2F, 0}, {1, 0.2F, 0});
        const LineSet lines = extract_lines(mesh);
        const RayScene scene{lines};
        const EdgeTruth truth{scene, front_camera()};
        const Lengths lengths = lengths_of(truth, file);
        EXPECT_NEAR(lengths.hidden, 200, 1e-3) << pixels;
        EXPECT_EQ(lengths.visible, 0) << pixels;
        for (const EdgePoint& point : truth.points()) {
            if (point.visibility != Visibility::hidden) continue;
            const auto blocker = truth.nearest_blocker(point);
            ASSERT_TRUE(blocker);
            EXPECT_NEAR(blocker->distance, pixels, 0.03);
        }
    }
}

TEST(EdgeTruth, APostBehindAPanelIsHidden) {
    Mesh mesh;
    add_block(mesh, {-1, -1, 0}, {1, 1, 0.01F});             // the panel, a pixel thick
    add_block(mesh, {-0.1F, -0.9F, -0.5F}, {0.1F, 0.9F, 0}); // the post, touching it
    const LineSet lines = extract_lines(mesh);
    const RayScene scene{lines};
    const EdgeTruth truth{scene, front_camera()};
    double hidden = 0;
    for (const EdgePoint& point : truth.points()) {
        const glm::vec3 p = lines.vertices[lines.segments[point.segment].p];
        if (std::abs(p.x) > 0.5F) continue; // a line of the panel
        EXPECT_EQ(point.visibility, Visibility::hidden) << point.at.x << ", " << point.at.y;
        hidden += static_cast<double>(point.pixels);
    }
    // Of the post's front alone, where the post touches the panel.
    EXPECT_GT(hidden, 2 * (180 + 20));
}

TEST(EdgeTruth, ABoxOnAFloorIsVisibleWhereItStands) {
    Mesh mesh;
    add_block(mesh, {-0.5F, -1, 0}, {0.5F, 1, 0.5F}); // its bottom lies in the floor, z = 0
    add_panel(mesh, {-1.5F, -1.5F}, {1.5F, 1.5F}, 0);
    Camera camera = front_camera();
    camera.view = glm::lookAt(glm::vec3{8, 0, 6}, glm::vec3{0}, glm::vec3{0, 0, 1});
    const LineSet lines = extract_lines(mesh);
    const RayScene scene{lines};
    const EdgeTruth truth{scene, camera};
    const auto standing_at = [&](float x) {
        Lengths lengths;
        for (const EdgePoint& point : truth.points()) {
            const Segment& segment = lines.segments[point.segment];
            const glm::vec3 p = lines.vertices[segment.p], q = lines.vertices[segment.q];
            if (p.x != x || q.x != x || p.z != 0 || q.z != 0) continue;
            const auto pixels = static_cast<double>(point.pixels);
            (point.visibility == Visibility::hidden ? lengths.hidden : lengths.visible) += pixels;
        }
        return lengths;
    };
    // Towards the eye the edge on the floor is 9.6 units away and 2 long.
    const double scale = 1000 / (0.8 * 7.5 + 0.6 * 6);
    EXPECT_NEAR(standing_at(0.5F).visible, 2 * scale, 0.1);
    EXPECT_EQ(standing_at(0.5F).hidden, 0);
    EXPECT_NEAR(standing_at(-0.5F).hidden, standing_at(-0.5F).visible + 2 * 1000 / 10.4, 3);
}

TEST(EdgeTruth, CoincidentFacesDoNotHide) {
    // A small sheet pasted on a large one, on its front and on its back.
    for (const bool in_front : {true, false}) {
        Mesh mesh;
        if (in_front) add_panel(mesh, {-9, -9}, {9, 9}, 0);
        add_panel(mesh, {-0.5F, -0.5F}, {0.5F, 0.5F}, 0);
        if (!in_front) add_panel(mesh, {-9, -9}, {9, 9}, 0);
        // The sheets have two materials, because with one no line would show there.
        mesh.groups = {{.object = "", .material = "a"}, {.object = "", .material = "b"}};
        mesh.triangle_group.assign(mesh.triangles.size(), 0);
        std::fill_n(mesh.triangle_group.begin() + (in_front ? 2 : 0), 2, 1U);
        const Lengths lengths = look(mesh, boundary);
        EXPECT_NEAR(lengths.visible, 400, 0.1);
        EXPECT_EQ(lengths.hidden + lengths.undecided, 0);
    }
}

TEST(EdgeTruth, TenTimesTheContactHidesTooLittle) {
    Mesh mesh;
    const float extent = 18 * std::sqrt(2.0F);
    add_panel(mesh, {-9, -9}, {9, 9}, 4e-6F * extent);
    add_stroke(mesh, {-1, 0.2F, 0}, {1, 0.2F, 0});
    EXPECT_EQ(look(mesh, file).visible, 0);
    EdgeTruthOptions planted;
    planted.rule.contact *= 10;
    EXPECT_NEAR(look(mesh, file, planted).visible, 200, 0.1);
}

TEST(EdgeTruth, ASmoothSurfaceDoesNotHideItsOwnOutline) {
    const Lengths outline = look(test::open_tube(0.5, 96), silhouette);
    // Two lines, 2 units high each, some 10 units away.
    EXPECT_NEAR(outline.visible, 400, 4);
    EXPECT_EQ(outline.hidden, 0);
}

TEST(EdgeTruth, BesideAnEdgeThatHidesNothingIsDecided) {
    Mesh mesh;
    add_panel(mesh, {-2, -2}, {2, 0}, 1);
    const float seen_at = 0.9F; // in the panel's plane 0, as seen from 10 units
    add_stroke(mesh, {-1, 0.005F, 0}, {1, 0.005F, 0});   // half a pixel above the panel's edge
    add_stroke(mesh, {-1, -0.005F, 0}, {1, -0.005F, 0}); // and below
    add_stroke(mesh, {-1, seen_at, 0}, {1, seen_at, 0});
    const Lengths lengths = look(mesh, file);
    EXPECT_NEAR(lengths.undecided, 400, 0.1);
    EXPECT_NEAR(lengths.visible, 200, 0.1);
}

TEST(EdgeTruth, IsTheSameWithAnyNumberOfThreads) {
    Mesh mesh = test::open_tube(0.5, 96);
    add_block(mesh, {-0.3F, -1.5F, -1.2F}, {0.3F, 1.5F, 1.2F});
    const LineSet lines = extract_lines(mesh);
    const RayScene scene{lines};
    const EdgeTruth one{scene, front_camera(), {.threads = 1}};
    const EdgeTruth three{scene, front_camera(), {.threads = 3}};
    ASSERT_EQ(one.points().size(), three.points().size());
    ASSERT_GT(one.points().size(), 1000U);
    for (std::size_t i = 0; i < one.points().size(); ++i) {
        EXPECT_EQ(one.points()[i].at, three.points()[i].at);
        EXPECT_EQ(one.points()[i].visibility, three.points()[i].visibility);
    }
}

TEST(SmoothPatches, EndAtLinesAndWhereThreeFacesMeet) {
    Mesh cube;
    add_block(cube, {0, 0, 0}, {1, 1, 1});
    const std::vector<std::uint32_t> sides = smooth_patches(extract_lines(cube));
    for (std::size_t i = 0; i < sides.size(); i += 2) {
        EXPECT_EQ(sides[i], i);
        EXPECT_EQ(sides[i + 1], i);
    }
    const std::vector<std::uint32_t> round = smooth_patches(extract_lines(test::open_tube(1, 48)));
    EXPECT_EQ(std::ranges::count(round, 0U), 96);
    // A fin on a smooth tube. Three faces share the edge of the fin.
    Mesh fin = test::open_tube(1, 48);
    fin.positions.emplace_back(3, 0, 0);
    fin.triangles.emplace_back(0, 1, 96);
    const std::vector<std::uint32_t> parted = smooth_patches(extract_lines(fin));
    EXPECT_EQ(parted.back(), 96U);
    EXPECT_EQ(std::ranges::count(parted, 0U), 96);
}

} // namespace
} // namespace lineatlas
