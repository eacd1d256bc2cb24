// The oracle on cases whose visibility is known by hand.

#include "truth.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <unistd.h>

#include "compare.hpp"
#include "truth_cache.hpp"

namespace lineatlas::bench {
namespace {

constexpr glm::ivec2 size{400, 400};

/// A camera at distance 10 that looks along -z at the origin, with 100 pixels per unit there.
Camera front_camera(bool perspective) {
    Camera camera;
    camera.size = size;
    camera.view = glm::lookAt(glm::vec3{0, 0, 10}, glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = perspective ? glm::perspective(2 * std::atan(0.2F), 1.0F, 1.0F, 100.0F)
                                    : glm::ortho(-2.0F, 2.0F, -2.0F, 2.0F, 1.0F, 100.0F);
    return camera;
}

void add_box(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.push_back({(corner & 1) != 0 ? high.x : low.x,
                                  (corner & 2) != 0 ? high.y : low.y,
                                  (corner & 4) != 0 ? high.z : low.z});
    }
    constexpr std::uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& q : quads) {
        mesh.triangles.push_back(glm::uvec3{q[0], q[1], q[2]} + first);
        mesh.triangles.push_back(glm::uvec3{q[0], q[2], q[3]} + first);
    }
}

void add_line(Mesh& mesh, glm::vec3 p, glm::vec3 q) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(p);
    mesh.positions.push_back(q);
    mesh.polylines.push_back({first, first + 1});
}

/// A unit sphere of small triangles.
Mesh sphere() {
    Mesh mesh;
    constexpr std::uint32_t rings = 48, sectors = 96;
    constexpr double pi = std::numbers::pi;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        for (std::uint32_t j = 0; j < sectors; ++j) {
            const double a = pi * i / rings, b = 2 * pi * j / sectors;
            mesh.positions.emplace_back(std::sin(a) * std::cos(b), std::cos(a),
                                        std::sin(a) * std::sin(b));
        }
    }
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < sectors; ++j) {
            const std::uint32_t k = (j + 1) % sectors;
            const std::uint32_t a = i * sectors + j, b = i * sectors + k;
            mesh.triangles.emplace_back(a, b, b + sectors);
            mesh.triangles.emplace_back(a, b + sectors, a + sectors);
        }
    }
    return mesh;
}

/// Adds a sheet `distance` before the plane z = 0 of the lines, where a pixel is 0.01.
void add_sheet(Mesh& mesh, float distance) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(),
                          {{-9, -9, distance}, {9, -9, distance}, {0, 9, distance}});
    mesh.triangles.emplace_back(first, first + 1, first + 2);
}

/// An open tube along y about (0, 0, 0).
Mesh tube(double radius, std::uint32_t sectors) {
    Mesh mesh;
    for (std::uint32_t j = 0; j < sectors; ++j) {
        const double angle = 2 * std::numbers::pi * (j + 0.25) / sectors;
        for (const float y : {-1.0F, 1.0F})
            mesh.positions.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
    }
    for (std::uint32_t j = 0; j < sectors; ++j) {
        const std::uint32_t a = 2 * j, b = 2 * ((j + 1) % sectors);
        mesh.triangles.emplace_back(a, a + 1, b + 1);
        mesh.triangles.emplace_back(a, b + 1, b);
    }
    return mesh;
}

/// The truth of every sample in a view of a mesh, for some kinds of line.
struct Seen {
    LineSet lines;
    ClippedLines clipped;
    std::vector<float> truth;
};

Seen see(const Mesh& mesh, const Camera& camera, LineKindMask kinds,
         const TruthOptions& options = {}) {
    Seen seen{extract_lines(mesh), {}, {}};
    seen.clipped = clip_lines(seen.lines, camera, 2, kinds);
    seen.truth = Oracle{seen.lines}.visibility(seen.clipped, camera, options);
    return seen;
}

double mean(const std::vector<float>& values) {
    double sum = 0;
    for (const float value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

class Truth : public testing::TestWithParam<bool> {
  protected:
    Camera camera_ = front_camera(GetParam());
    static constexpr LineKindMask file = mask_of(LineKind::file);
};

TEST_P(Truth, LineBehindABoxIsHiddenWhereTheBoxIs) {
    Mesh mesh;
    add_box(mesh, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    add_line(mesh, {-1.503, 0.001, -1}, {1.497, 0.001, -1});
    const Seen seen = see(mesh, camera_, file);
    ASSERT_GT(seen.truth.size(), 100U);
    const double l = static_cast<double>(seen.truth.size());
    // The box's front face covers this share of the line's window.
    const double half = GetParam() ? 0.5 * 11 / 9.5 : 0.5;
    for (std::size_t j = 0; j < seen.truth.size(); ++j) {
        const double from = -1.503 + 3 * static_cast<double>(j) / l;
        const double to = from + 3 / l;
        const bool beside = to < -half || from > half;
        const bool behind = from > -half && to < half; // else it straddles the box's border
        if (beside || behind) {
            EXPECT_EQ(seen.truth[j], beside ? 1 : 0) << j;
        }
    }
}

TEST_P(Truth, LineBeforeABoxIsVisible) {
    Mesh mesh;
    add_box(mesh, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    add_line(mesh, {-1.5, 0, 0.6}, {1.5, 0, 0.6});
    EXPECT_EQ(mean(see(mesh, camera_, file).truth), 1);
}

TEST_P(Truth, LineOnAFaceIsVisible) {
    Mesh mesh;
    add_box(mesh, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    add_line(mesh, {-0.4, 0.1, 0.5}, {0.4, 0.2, 0.5});
    EXPECT_EQ(mean(see(mesh, camera_, file).truth), 1);
}

TEST_P(Truth, AThinPlateHidesHoweverNearItIs) {
    for (const float pixels : {0.3F, 0.7F, 1.0F, 1.5F, 2.5F}) {
        Mesh mesh;
        add_sheet(mesh, 0.01F * pixels);
        add_line(mesh, {-1, 0, 0}, {1, 0, 0});
        EXPECT_EQ(mean(see(mesh, camera_, file).truth), 0) << pixels;
        // A sheet behind the line hides nothing.
        mesh = {};
        add_sheet(mesh, -0.01F * pixels);
        add_line(mesh, {-1, 0, 0}, {1, 0, 0});
        EXPECT_EQ(mean(see(mesh, camera_, file).truth), 1) << pixels;
    }
}

TEST_P(Truth, ABoxsFarEdgesAreHiddenHoweverThinItIs) {
    Mesh mesh;
    add_box(mesh, {-1, -1, -0.007F}, {1, 1, 0});
    const Seen seen = see(mesh, camera_, mask_of(LineKind::crease));
    int behind = 0;
    for (std::size_t i = 0; i < seen.lines.segments.size(); ++i) {
        const Segment& segment = seen.lines.segments[i];
        const float depth = seen.lines.vertices[segment.p].z + seen.lines.vertices[segment.q].z;
        if (depth > -0.01F || seen.clipped.samples(i) < 10) continue;
        ++behind;
        // Half of the quad of an outline lies beside the box, a little less in perspective.
        const std::uint32_t middle = seen.clipped.offsets[i] + seen.clipped.samples(i) / 2;
        EXPECT_NEAR(seen.truth[middle], GetParam() ? 0.43F : 0.5F, 0.04F) << i;
    }
    EXPECT_EQ(behind, 4);
}

TEST_P(Truth, CoincidentFacesDoNotHide) {
    // Positions of a sheet 18 units wide are known to 2e-6 of its extent.
    const auto visible = [&](float distance, const TruthOptions& options = {}) {
        Mesh mesh;
        add_sheet(mesh, distance);
        add_line(mesh, {-1, 0, 0}, {1, 0, 0});
        return mean(see(mesh, camera_, file, options).truth);
    };
    const float extent = 18 * std::sqrt(2.0F);
    EXPECT_EQ(visible(0), 1);
    EXPECT_EQ(visible(1e-6F * extent), 1);
    EXPECT_EQ(visible(4e-6F * extent), 0);
    // Planted: with ten times the contact the sheet does not hide the line.
    TruthOptions planted;
    planted.rule.contact *= 10;
    EXPECT_EQ(visible(4e-6F * extent, planted), 1);
}

TEST_P(Truth, APostBehindAPanelIsHiddenButByTheOldRule) {
    Mesh mesh;
    add_box(mesh, {-1, -1, 0}, {1, 1, 0.01F});             // the panel, a pixel thick
    add_box(mesh, {-0.1F, -0.9F, -0.5F}, {0.1F, 0.9F, 0}); // the post, touching it
    const LineSet lines = extract_lines(mesh);
    const ClippedLines clipped = clip_lines(lines, camera_, 2);
    const auto shown = [&](const Oracle& oracle) {
        const std::vector<float> truth = oracle.visibility(clipped, camera_);
        double sum = 0;
        for (std::size_t i = 0; i < lines.segments.size(); ++i) {
            const Segment& segment = lines.segments[i];
            if (std::abs(lines.vertices[segment.p].x) > 0.5F) continue; // of the panel
            for (std::uint32_t j = clipped.offsets[i]; j < clipped.offsets[i + 1]; ++j)
                sum += static_cast<double>(truth[j]);
        }
        return sum;
    };
    EXPECT_EQ(shown(Oracle{lines}), 0);
    // Planted: all triangles are one patch.
    const Oracle planted{lines, std::vector<std::uint32_t>(lines.triangles.size(), 0)};
    EXPECT_GT(shown(planted), 100);
}

TEST_P(Truth, ABoxOnAFloorIsVisibleWhereItStands) {
    Mesh mesh;
    add_box(mesh, {-0.5F, 0, -0.5F}, {0.5F, 1, 0.5F});
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{-3, 0, -3}, {3, 0, -3}, {3, 0, 3}, {-3, 0, 3}});
    mesh.triangles.emplace_back(first, first + 2, first + 1);
    mesh.triangles.emplace_back(first, first + 3, first + 2);
    camera_.view = glm::lookAt(glm::vec3{3, 4, 8}, glm::vec3{0}, glm::vec3{0, 1, 0});
    const Seen seen = see(mesh, camera_, mask_of(LineKind::crease));
    int standing = 0;
    for (std::size_t i = 0; i < seen.lines.segments.size(); ++i) {
        const glm::vec3 middle = 0.5F * (seen.lines.vertices[seen.lines.segments[i].p] +
                                         seen.lines.vertices[seen.lines.segments[i].q]);
        if (middle.y != 0 || seen.clipped.samples(i) == 0) continue;
        const bool front = middle.x + middle.z > 0; // two edges face the eye, two are behind
        ++standing;
        for (std::uint32_t j = 2; j + 2 < seen.clipped.samples(i); ++j)
            EXPECT_EQ(seen.truth[seen.clipped.offsets[i] + j], front ? 1 : 0) << i << ", " << j;
    }
    EXPECT_EQ(standing, 4);
}

TEST_P(Truth, ASmoothSurfaceDoesNotHideItsOwnOutline) {
    // The radius is three pixels. Half a pixel inside the outline the surface is 1.7 pixels nearer.
    const Mesh mesh = tube(0.03, 48);
    const LineKindMask outline = mask_of(LineKind::silhouette);
    EXPECT_GT(mean(see(mesh, camera_, outline).truth), 0.97);
    TruthOptions planted;
    planted.rule.patch_pixels = 0;
    EXPECT_LT(mean(see(mesh, camera_, outline, planted).truth), 0.8);
    // Another surface at that distance hides the outline.
    Mesh behind = mesh;
    add_sheet(behind, 0.035F);
    EXPECT_EQ(mean(see(behind, camera_, outline).truth), 0);
}

TEST_P(Truth, WhatStandsBeforeTheNearPlaneHidesNothing) {
    Mesh mesh;
    add_sheet(mesh, 9.5F); // half a unit from the eye; the near plane is at one
    add_line(mesh, {-1, 0, 0}, {1, 0, 0});
    EXPECT_EQ(mean(see(mesh, camera_, file).truth), 1);
}

TEST_P(Truth, HalfTheQuadBesideASheet) {
    // The sheet's edge runs along the middle of the line, so half of its width is hidden.
    Mesh mesh;
    mesh.positions = {{-9, 0, 1}, {9, 0, 1}, {0, 9, 1}};
    mesh.triangles = {{0, 1, 2}};
    add_line(mesh, {-1, 0, 0}, {1, 0, 0});
    for (const float share : see(mesh, camera_, file).truth) EXPECT_NEAR(share, 0.5F, 0.02F);
}

TEST_P(Truth, CreasesOfACubeAreVisibleInFrontAndHiddenBehind) {
    Mesh mesh;
    add_box(mesh, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    camera_.view = glm::lookAt(glm::vec3{5, 4, 8}, glm::vec3{0}, glm::vec3{0, 1, 0});
    const Seen seen = see(mesh, camera_, mask_of(LineKind::crease));
    ASSERT_EQ(seen.lines.segments.size(), 12U);
    for (std::size_t i = 0; i < 12; ++i) {
        const glm::vec3 middle = 0.5F * (seen.lines.vertices[seen.lines.segments[i].p] +
                                         seen.lines.vertices[seen.lines.segments[i].q]);
        // The eye sees the corner (1, 1, 1); three edges meet in the opposite one.
        const bool hidden = (middle.x < 0) + (middle.y < 0) + (middle.z < 0) == 2;
        const std::uint32_t l = seen.clipped.samples(i);
        for (std::uint32_t j = 0; j < l; ++j) {
            const float share = seen.truth[seen.clipped.offsets[i] + j];
            // Hidden edges stick out a little where they reach the outline.
            if (j < 2 || j + 2 >= l) continue;
            EXPECT_EQ(share, hidden ? 0 : 1) << i << ", " << j;
        }
    }
}

TEST_P(Truth, SilhouetteOfASphereIsAtLeastHalfVisible) {
    const Seen seen = see(sphere(), camera_, mask_of(LineKind::silhouette));
    ASSERT_GT(seen.truth.size(), 200U);
    std::size_t hidden = 0;
    for (const float share : seen.truth) hidden += share < 0.4F ? 1 : 0;
    EXPECT_LT(static_cast<double>(hidden), 0.02 * static_cast<double>(seen.truth.size()));
}

TEST_P(Truth, MoreRaysChangeLittle) {
    Mesh mesh = sphere();
    add_box(mesh, {-0.3, -1.5, -1.2}, {0.3, 1.5, 1.2});
    const double once = mean(see(mesh, camera_, all_line_kinds).truth);
    const double twice = mean(see(mesh, camera_, all_line_kinds, {.rays = 144}).truth);
    EXPECT_NEAR(once, twice, 0.002);
}

TEST_P(Truth, IsTheSameWithAnyNumberOfThreads) {
    const Mesh mesh = sphere();
    EXPECT_EQ(see(mesh, camera_, all_line_kinds, {.threads = 1}).truth,
              see(mesh, camera_, all_line_kinds, {.threads = 3}).truth);
}

TEST_P(Truth, CacheGivesBackExactlyWhatWasComputed) {
    // Shares of exactly one half lie on the threshold of a wrong sample.
    Mesh mesh;
    mesh.positions = {{-9, 0, 1}, {9, 0, 1}, {0, 9, 1}};
    mesh.triangles = {{0, 1, 2}};
    add_line(mesh, {-1, 0, 0}, {1, 0, 0});
    const Seen seen = see(mesh, camera_, file);
    const Oracle oracle{seen.lines};
    const auto folder = std::filesystem::path{testing::TempDir()} /
                        ("lineatlas-truth-" + std::to_string(getpid()) + (GetParam() ? "p" : "o"));
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(cached_visibility(oracle, seen.clipped, camera_, {}, folder), seen.truth);
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator{folder}, {}), 1);
    std::filesystem::remove_all(folder);
}

TEST_P(Truth, ComparisonFindsPlantedErrors) {
    Mesh mesh;
    add_box(mesh, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    add_line(mesh, {-1.5, 0, -1}, {1.5, 0, -1});
    const Seen seen = see(mesh, camera_, file);
    std::vector<std::uint8_t> alpha;
    for (const float share : seen.truth) {
        alpha.push_back(static_cast<std::uint8_t>(std::lround(share * 255)));
    }
    const ViewSamples view{seen.lines, seen.clipped, alpha, seen.truth};
    EXPECT_EQ(compare(view).all.wrong(), 0U);
    alpha.front() = 0;             // true: visible
    alpha[alpha.size() / 2] = 255; // true: hidden
    const Figures figures = compare({seen.lines, seen.clipped, alpha, seen.truth}).all;
    EXPECT_EQ(figures.false_hidden, 1U);
    EXPECT_EQ(figures.false_visible, 1U);
}

INSTANTIATE_TEST_SUITE_P(Projections, Truth, testing::Bool(),
                         [](const auto& info) { return info.param ? "perspective" : "parallel"; });

} // namespace
} // namespace lineatlas::bench
