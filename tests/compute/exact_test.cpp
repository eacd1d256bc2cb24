// surfaces, tile_lists, visible and spans together: drawings with answers known by hand, and every
// face of models in double precision.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "compare.hpp"
#include "compute/cpp/cpp_device.hpp"
#include "devices.hpp"
#include "exact_support.hpp"
#include "lineatlas/scenes.hpp"
#include "planted_error.hpp"
#include "shared/constants.h"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace {

constexpr int side = 200;
constexpr float exactly = 0.02F; // pixels

void add_triangle(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
}

void add_quad(Mesh& mesh, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
    add_triangle(mesh, a, b, c);
    add_triangle(mesh, a, c, d);
}

/// Across the line of sight.
void add_panel(Mesh& mesh, glm::vec2 low, glm::vec2 high, float z) {
    add_quad(mesh, {low, z}, {high.x, low.y, z}, {high, z}, {low.x, high.y, z});
}

void add_box(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
    Mesh box = cube();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3 p : box.positions) {
        mesh.positions.push_back(glm::mix(low, high, 0.5F * p + 0.5F));
    }
    for (const glm::uvec3 t : box.triangles) mesh.triangles.push_back(t + first);
}

class ExactTest : public testing::TestWithParam<TestDevice> {
  protected:
    static void TearDownTestSuite() { devices_.clear(); }

    ExactResult find(const LineSet& lines, const Camera& camera,
                     LineKindMask kinds = all_line_kinds) const {
        return find_exactly(device(), lines, camera, kinds);
    }
    static compute::Device& device() {
        std::unique_ptr<compute::Device>& device = devices_[GetParam().name];
        if (!device) device = GetParam().make();
        return *device;
    }
    /// Pixels that are seen of a line through the mesh.
    float seen(Mesh mesh, glm::vec3 p, glm::vec3 q, const Camera& camera) const {
        add_polyline(mesh, std::array{p, q});
        const LineSet lines = extract_lines(mesh);
        return visible_length(lines, find(lines, camera), p, q);
    }
    float seen(const Mesh& mesh, glm::vec3 p, glm::vec3 q) const {
        return seen(mesh, p, q, square_camera(side));
    }
    /// Of an edge of the mesh itself.
    float seen_edge(const Mesh& mesh, glm::vec3 p, glm::vec3 q, const Camera& camera) const {
        const LineSet lines = extract_lines(mesh);
        return visible_length(lines, find(lines, camera), p, q);
    }

  private:
    static inline std::map<std::string, std::unique_ptr<compute::Device>> devices_;
};

std::vector<TestDevice> devices_in_both_forms() {
    std::vector<TestDevice> devices = test_devices();
    devices.push_back(cpp_as_gpu());
    return devices;
}

INSTANTIATE_TEST_SUITE_P(OnDevice, ExactTest, testing::ValuesIn(devices_in_both_forms()),
                         [](const auto& test) { return test.param.name; });

TEST_P(ExactTest, APostBehindAPanel) {
    for (const float behind : {0.3F, 0.7F, 1.0F, 1.5F, 40.0F}) {
        Mesh mesh;
        add_panel(mesh, {60, 20}, {150.25F, 180}, 0);
        EXPECT_NEAR(seen(mesh, {10, 100, -behind}, {190, 100, -behind}), 89.75F, exactly) << behind;
        EXPECT_NEAR(seen(mesh, {70, 30, -behind}, {140, 170, -behind}), 0, 1e-6F) << behind;
        EXPECT_NEAR(seen(mesh, {10, 100, behind}, {190, 100, behind}), 180, exactly) << behind;
    }
}

TEST_P(ExactTest, AThinPlateHidesItsFarEdges) {
    const Camera camera = square_camera(side, 500, 10);
    for (const float thickness : {0.3F, 0.7F, 1.0F, 1.5F}) {
        Mesh mesh;
        add_box(mesh, {50, 60, -thickness}, {150, 140, 0});
        EXPECT_NEAR(seen_edge(mesh, {50, 60, 0}, {150, 60, 0}, camera), 100, exactly) << thickness;
        EXPECT_NEAR(seen_edge(mesh, {50, 60, -thickness}, {150, 60, -thickness}, camera), 0, 1e-6F)
            << thickness;
    }
}

TEST_P(ExactTest, ALineThroughAFaceIsSeenBeforeIt) {
    Mesh mesh;
    add_panel(mesh, {20, 20}, {180, 180}, 0);
    EXPECT_NEAR(seen(mesh, {40, 100, 30}, {160, 100, -60}), 40, exactly);
}

TEST_P(ExactTest, SegmentsAreNotLookedAtAgainForTheirSpans) {
    // More than there is room for in a first frame: what is seen of each is counted by then.
    Mesh mesh;
    add_panel(mesh, {80, 0}, {120, 200}, 0);
    for (int i = 1; i <= 5000; ++i) {
        const float y = 0.039F * static_cast<float>(i);
        add_polyline(mesh, std::array{glm::vec3{10, y, -1}, glm::vec3{190, y, -1}});
    }
    const LineSet lines = extract_lines(mesh);
    const ExactResult result = find(lines, square_camera(side));
    EXPECT_EQ(result.looks, 1);
    ASSERT_GE(result.span_offsets.back(), 10000U);
    for (const float y : {0.039F, 0.039F * 5000})
        EXPECT_NEAR(visible_length(lines, result, {10, y, -1}, {190, y, -1}), 140, exactly) << y;
}

TEST_P(ExactTest, WhatTouchesAFaceIsSeen) {
    Mesh mesh;
    add_panel(mesh, {0, 0}, {200, 200}, 0); // a diagonal of 283: 5.7e-4 touch
    EXPECT_NEAR(seen(mesh, {40, 100, 0}, {160, 100, 0}), 120, exactly);
    EXPECT_NEAR(seen(mesh, {40, 100, -4e-4F}, {160, 100, -4e-4F}), 120, exactly);
    EXPECT_NEAR(seen(mesh, {40, 100, -2e-3F}, {160, 100, -2e-3F}), 0, 1e-6F);
    mesh.precision = 2e-3F; // each of the two may be off by that
    EXPECT_NEAR(seen(mesh, {40, 100, -2e-3F}, {160, 100, -2e-3F}), 120, exactly);
    EXPECT_NEAR(seen(mesh, {40, 100, -5e-3F}, {160, 100, -5e-3F}), 0, 1e-6F);
}

TEST_P(ExactTest, ABoxOnAFloor) {
    // Seen from above at a slant: what of the box's lowest edges is before it lies on the floor.
    Mesh mesh;
    add_quad(mesh, {-10, 0, -10}, {-10, 0, 10}, {10, 0, 10}, {10, 0, -10});
    add_box(mesh, {-1, 0, -1}, {1, 2, 1});
    const Camera camera = make_camera({.eye = {3, 6, 20}, .target = {0, 0, 0}}, {400, 300},
                                      {{-10, 0, -10}, {10, 2, 10}});
    const LineSet lines = extract_lines(mesh);
    const ExactResult result = find(lines, camera);
    const auto length = [&](glm::vec3 p, glm::vec3 q) {
        const auto place = [&](glm::vec3 v) {
            const glm::vec4 clip = camera.clip_from_world() * glm::vec4{v, 1};
            return glm::vec2{clip} / clip.w * 0.5F * glm::vec2{camera.size};
        };
        return glm::distance(place(p), place(q));
    };
    const std::array corners{glm::vec3{-1, 0, 1}, glm::vec3{1, 0, 1}, glm::vec3{1, 0, -1},
                             glm::vec3{-1, 0, -1}};
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(visible_length(lines, result, corners[k], corners[k + 1]),
                    length(corners[k], corners[k + 1]), exactly);
    }
    EXPECT_NEAR(visible_length(lines, result, corners[2], corners[3]), 0, exactly);
    EXPECT_NEAR(visible_length(lines, result, corners[3], corners[0]), 0, exactly);
}

TEST_P(ExactTest, CoincidentFacesAndTouchingBoxes) {
    const Camera camera = square_camera(side, 600, 10);
    Mesh mesh;
    // Of one material the common edges were seams.
    mesh.groups = {{.object = "", .material = "left"},
                   {.object = "", .material = "right"},
                   {.object = "", .material = "panel"}};
    const auto of_group = [&](std::uint32_t group) {
        mesh.triangle_group.resize(mesh.triangles.size(), group);
    };
    add_box(mesh, {20, 50, -40}, {100, 150, 0});
    of_group(0);
    add_box(mesh, {100, 50, -40}, {180, 150, 0}); // shares the face at x = 100
    of_group(1);
    add_panel(mesh, {30, 60}, {170, 140}, 0); // lies in the front faces of both
    of_group(2);
    // The common edge is in front; the others of that face are inside or behind.
    EXPECT_NEAR(seen_edge(mesh, {100, 50, 0}, {100, 150, 0}, camera), 100, exactly);
    EXPECT_NEAR(seen_edge(mesh, {100, 50, -40}, {100, 150, -40}, camera), 0, 1e-6F);
    EXPECT_NEAR(seen_edge(mesh, {30, 60, 0}, {170, 60, 0}, camera), 140, exactly);
}

TEST_P(ExactTest, PlanksThatOverlap) {
    // The upper edge of the lower one lies behind the foot of the upper one.
    Mesh mesh;
    add_quad(mesh, {20, 20, 2}, {180, 20, 2}, {180, 80, 0}, {20, 80, 0});
    add_quad(mesh, {20, 70, 2}, {180, 70, 2}, {180, 130, 0}, {20, 130, 0});
    const Camera camera = square_camera(side);
    EXPECT_NEAR(seen_edge(mesh, {20, 70, 2}, {180, 70, 2}, camera), 160, exactly);
    EXPECT_NEAR(seen_edge(mesh, {180, 80, 0}, {20, 80, 0}, camera), 0, 1e-6F);
}

TEST_P(ExactTest, AFold) {
    // The ridge of a tent, seen from above one side: it hides what is behind it, and is seen
    // itself.
    Mesh mesh;
    add_quad(mesh, {20, 40, 40}, {180, 40, 40}, {180, 120, 0}, {20, 120, 0});
    add_quad(mesh, {180, 120, 0}, {180, 100, -40}, {20, 100, -40}, {20, 120, 0});
    const Camera camera = square_camera(side);
    EXPECT_NEAR(seen_edge(mesh, {180, 120, 0}, {20, 120, 0}, camera), 160, exactly);
    EXPECT_NEAR(seen_edge(mesh, {180, 100, -40}, {20, 100, -40}, camera), 0, 1e-6F);
    // Down the far side from the ridge: hidden all along, however near to the ridge.
    EXPECT_NEAR(seen(mesh, {100, 120, 0}, {100, 100, -40}), 0, exactly);
    // A hair beside the ridge: above it, and below it behind the near side.
    EXPECT_NEAR(seen(mesh, {40, 120.03F, -1}, {160, 120.03F, -1}), 120, exactly);
    EXPECT_NEAR(seen(mesh, {40, 119.97F, -1}, {160, 119.97F, -1}), 0, 1e-6F);
}

TEST_P(ExactTest, AConesTip) {
    Mesh mesh;
    const glm::vec3 tip{100, 150, 20};
    for (int k = 0; k < 24; ++k) {
        const auto at = [&](int i) {
            const float angle = 2 * 3.14159265F * static_cast<float>(i) / 24;
            return glm::vec3{100 + 50 * std::cos(angle), 50, 20 + 50 * std::sin(angle)};
        };
        add_triangle(mesh, tip, at(k + 1), at(k));
    }
    // From the tip straight down inside the cone: hidden but for the rounding at its start.
    EXPECT_NEAR(seen(mesh, tip, {100, 60, 20}), 0, exactly);
    // From the tip upwards: free.
    EXPECT_NEAR(seen(mesh, tip, {100, 190, 20}), 40, exactly);
    // From the tip sideways behind the cone and beyond: it leaves behind its flank at once.
    EXPECT_NEAR(seen(mesh, tip, {190, 150, -30}), 90, exactly);
}

TEST_P(ExactTest, FacesThroughTheNearPlane) {
    const Camera camera = square_camera(side, 100, 5);
    Mesh mesh;
    // A floor from behind the eye to far away; a line under it, another above.
    add_quad(mesh, {-2000, 60, 400}, {2200, 60, 400}, {2200, 60, -900}, {-2000, 60, -900});
    EXPECT_NEAR(seen(mesh, {60, 50, 0}, {140, 50, 0}, camera), 0, 1e-6F);
    EXPECT_NEAR(seen(mesh, {60, 70, 0}, {140, 70, 0}, camera), 80, exactly);
    // A wall across the eye's own place hides nothing; one just beyond the near plane all.
    Mesh wall;
    add_panel(wall, {-500, -500}, {700, 700}, 96);
    EXPECT_NEAR(seen(wall, {60, 50, 0}, {140, 50, 0}, camera), 80, exactly);
    Mesh nearer;
    add_panel(nearer, {-500, -500}, {700, 700}, 94);
    EXPECT_NEAR(seen(nearer, {60, 50, 0}, {140, 50, 0}, camera), 0, 1e-6F);
    // A slanted one: only what is beyond the near plane hides. It crosses z = 95 at x = 100, there
    // a point of the wall is seen at x = 100 too.
    Mesh slanted;
    add_quad(slanted, {0, -500, 195}, {200, -500, -5}, {200, 700, -5}, {0, 700, 195});
    EXPECT_NEAR(seen(slanted, {20, 50, -40}, {180, 50, -40}, camera), 80 / 1.4F, exactly);
}

TEST_P(ExactTest, TwoBodiesThroughEachOther) {
    // The bar's edges end where they enter the box.
    const Camera camera = square_camera(side);
    Mesh mesh;
    add_box(mesh, {60, 40, -50}, {140, 160, 0});
    add_box(mesh, {20, 90, -20}, {100, 110, -10});
    EXPECT_NEAR(seen_edge(mesh, {20, 90, -10}, {100, 90, -10}, camera), 40, exactly);
    Mesh deeper = mesh;
    add_box(deeper, {90, 20, -30}, {110, 180, 10}); // stands out before the box
    EXPECT_NEAR(seen_edge(deeper, {90, 20, 10}, {90, 180, 10}, camera), 160, exactly);
    EXPECT_NEAR(seen_edge(deeper, {60, 40, 0}, {140, 40, 0}, camera), 60, exactly);
}

TEST_P(ExactTest, ALineSeenEndOn) {
    const Camera camera = square_camera(side);
    Mesh mesh;
    add_panel(mesh, {20, 20}, {90, 180}, 0);
    // The second segment gives the first a path: one alone that is a point is not drawn.
    const auto line = [](float x) {
        return std::array{glm::vec3{x, 100, -10}, glm::vec3{x, 100, -60},
                          glm::vec3{x + 20, 100, -60}};
    };
    Mesh hidden = mesh, shown = mesh;
    add_polyline(hidden, line(50));
    add_polyline(shown, line(150));
    for (const auto& [model, count] : {std::pair{hidden, 0U}, std::pair{shown, 2U}}) {
        const LineSet lines = extract_lines(model);
        const ExactResult result = find(lines, camera, mask_of(LineKind::file));
        EXPECT_EQ(result.span_offsets.back(), count);
    }
}

TEST_P(ExactTest, MoreGapsThanAPieceHolds) {
    // A fence over 120 pixels, half of it slats. The order of the slats is not that of their
    // places.
    for (const int slats : {60, 240}) {
        const float step = 120 / static_cast<float>(slats);
        Mesh mesh;
        for (int k = 0; k < slats; ++k) {
            const float x = 40 + step * static_cast<float>(k * 7 % slats);
            add_panel(mesh, {x, 20}, {x + step / 2, 180}, 0);
        }
        add_polyline(mesh, std::array{glm::vec3{30, 100, -5}, glm::vec3{170, 100, -5}});
        const LineSet lines = extract_lines(mesh);
        const ExactResult result = find(lines, square_camera(side), mask_of(LineKind::file));
        EXPECT_EQ(result.span_offsets.back(), static_cast<std::uint32_t>(slats) + 1);
        EXPECT_NEAR(visible_length(lines, result, {30, 100, -5}, {170, 100, -5}), 80,
                    static_cast<float>(slats) * 1e-3F);
    }
}

TEST_P(ExactTest, EndsMeetAndSayWhatTheyAre) {
    Mesh mesh;
    add_panel(mesh, {60, 20}, {120, 180}, 0);
    add_polyline(
        mesh, std::array{glm::vec3{20, 100, -5}, glm::vec3{90, 100, -5}, glm::vec3{160, 100, -5}});
    const LineSet lines = extract_lines(mesh);
    const ExactResult result = find(lines, square_camera(side), mask_of(LineKind::file));
    ASSERT_EQ(result.intervals.size(), 4U);
    const std::array<float, 5> ends{20, 60, 90, 120, 160};
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(result.intervals[k].start[0], ends[k], 1e-3F) << k;
        EXPECT_NEAR(result.intervals[k].end[0], ends[k + 1], 1e-3F) << k;
        EXPECT_NEAR(result.intervals[k].start_world[0], ends[k], 1e-3F) << k;
        EXPECT_EQ(result.intervals[k].flags & LA_INTERVAL_VISIBLE, k == 0 || k == 3 ? 1U : 0U) << k;
    }
    const auto start = [&](std::size_t k) {
        return result.intervals[k].flags >> LA_INTERVAL_START_SHIFT & LA_END_MASK;
    };
    const auto end = [&](std::size_t k) {
        return result.intervals[k].flags >> LA_INTERVAL_END_SHIFT & LA_END_MASK;
    };
    EXPECT_EQ(start(0), LA_END_PATH);
    EXPECT_EQ(end(0), LA_END_HIDDEN);
    EXPECT_EQ(end(1), LA_END_JOIN); // hidden on both sides of the joint
    EXPECT_EQ(start(2), LA_END_JOIN);
    EXPECT_EQ(end(3), LA_END_PATH);
}

// --- every face, in double precision

using Range = std::pair<double, double>;

/// Where face t hides segment i, of 0 at p' to 1 at q' on the screen; empty if nowhere. Faces at
/// the near plane are left out: the cameras of these tests stand outside.
Range hidden_by(const LineSet& lines, const Camera& camera, const ClippedSegment& clipped,
                std::size_t i, std::size_t t, double contact) {
    constexpr Range nothing{2, -1};
    const auto at = [&](std::uint32_t v) { return glm::dvec3{lines.vertices[v]}; };
    const glm::uvec3 face = lines.triangles[t];
    const Segment& segment = lines.segments[i];
    const auto holds = [&](std::uint32_t v) { return face.x == v || face.y == v || face.z == v; };
    if (holds(segment.p) && holds(segment.q)) return nothing;
    const std::array corners{at(face.x), at(face.y), at(face.z)};
    const glm::dvec4 eye{camera.eye()};
    const auto to_eye = [&](glm::dvec3 from) { return glm::dvec3{eye} - from * eye.w; };
    glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (!(glm::length(normal) > 0)) return nothing;
    normal = glm::normalize(normal);
    const double sign = glm::dot(normal, to_eye(corners[0])) > 0 ? 1 : -1;
    const glm::dvec3 p = at(segment.p), q = at(segment.q);
    const glm::dvec3 a = glm::mix(p, q, double{clipped.t0}), b = glm::mix(p, q, double{clipped.t1});
    const glm::dmat4 m{camera.clip_from_world()};
    const double wa = (m * glm::dvec4{a, 1}).w, wb = (m * glm::dvec4{b, 1}).w;
    Range range{0, 1};
    const auto keep = [&](double at_a, double at_b) {
        at_a /= wa;
        at_b /= wb;
        if (at_a < 0 && at_b < 0) range = nothing;
        if (at_a < 0 && at_b >= 0) range.first = std::max(range.first, at_a / (at_a - at_b));
        if (at_b < 0 && at_a >= 0) range.second = std::min(range.second, at_a / (at_a - at_b));
    };
    keep(-sign * glm::dot(normal, a - corners[0]) - contact,
         -sign * glm::dot(normal, b - corners[0]) - contact);
    for (std::size_t k = 0; k < 3 && range.first < range.second; ++k) {
        const auto side_of = [&](glm::dvec3 x) {
            return sign * glm::dot(to_eye(x), glm::cross(corners[k] - x, corners[(k + 1) % 3] - x));
        };
        keep(side_of(a), side_of(b));
    }
    return range.first < range.second ? range : nothing;
}

/// Parts and gaps under 0.02 px are left out, judged by rounded ends.
constexpr double longest_left_out = 0.021;

/// What a result says of a segment, beside the truth, pixels.
struct Wrong {
    double pixels = 0;  ///< missing or too many
    double allowed = 0; ///< in parts and gaps so short that they may be left out
};

Wrong compare_with_all_faces(const LineSet& lines, const Camera& camera, const ExactResult& result,
                             std::size_t i, double contact) {
    std::vector<Range> hidden;
    for (std::size_t t = 0; t < lines.triangles.size(); ++t) {
        const Range range = hidden_by(lines, camera, result.clipped[i], i, t, contact);
        if (range.first < range.second) hidden.push_back(range);
    }
    std::ranges::sort(hidden);
    // Changes of "visible", of the truth and of the result: where only one is, the length counts.
    std::vector<std::pair<double, int>> changes;
    double reached = 0;
    for (const auto& [from, to] : hidden) {
        if (from > reached) changes.insert(changes.end(), {{reached, 1}, {from, -1}});
        reached = std::max(reached, to);
    }
    if (reached < 1) changes.insert(changes.end(), {{reached, 1}, {1, -1}});
    for (std::uint32_t k = result.span_offsets[i]; k < result.span_offsets[i + 1]; ++k) {
        changes.insert(changes.end(),
                       {{double{result.spans[2 * k]}, 2}, {double{result.spans[2 * k + 1]}, -2}});
    }
    const double length = static_cast<float>(result.arcs[i + 1] - result.arcs[i]);
    const double pixels = length / LA_ARC_UNITS_PER_PIXEL;
    Wrong wrong;
    double last = 0;
    for (const auto& [place, change] : changes) { // the truth's are in order
        if (std::abs(change) == 1 && (place - last) * pixels < longest_left_out)
            wrong.allowed += (place - last) * pixels;
        if (std::abs(change) == 1) last = place;
    }
    std::ranges::sort(changes);
    double before = 0;
    int state = 0;
    for (const auto& [place, change] : changes) {
        if (state == 1 || state == 2) wrong.pixels += (place - before) * pixels;
        before = place;
        state += change;
    }
    return wrong;
}

/// Every `stride`th segment of a frame.
struct Compared {
    double looked_at = 0; ///< pixels
    double excess = 0;    ///< pixels that are wrong beyond what is allowed
    double worst = 0;     ///< of one segment
};

Compared compare_with_all_faces(const LineSet& lines, const Camera& camera,
                                const ExactResult& result, std::size_t stride) {
    const double contact = 2e-6 * glm::distance(lines.bounds.min, lines.bounds.max);
    constexpr double rounding = 1.5e-4; // of both ends of a segment's parts
    Compared compared;
    for (std::size_t i = 0; i < lines.segments.size(); i += stride) {
        if (result.arcs[i] == result.arcs[i + 1]) continue;
        const Wrong own = compare_with_all_faces(lines, camera, result, i, contact);
        compared.excess += own.pixels - own.allowed - rounding;
        compared.worst = std::max(compared.worst, own.pixels - own.allowed);
        compared.looked_at +=
            (result.arcs[i + 1] - result.arcs[i]) / double{LA_ARC_UNITS_PER_PIXEL};
    }
    return compared;
}

void expect_exact(const Compared& compared, double at_least) {
    EXPECT_GT(compared.looked_at, at_least);
    EXPECT_LT(compared.excess, 0);
    EXPECT_LT(compared.worst, exactly);
}

TEST_P(ExactTest, FindsWhatOthersFindBitByBit) {
    if (GetParam().slow) GTEST_SKIP() << "on the other devices";
    const auto cpp = compute::make_cpp_device();
    for (const char* name : {"clevis", "house"}) {
        const Scene scene = make_scene(name);
        const LineSet lines = extract_lines(scene.mesh);
        const Camera camera = make_camera(scene.view(0.3F), {640, 480}, lines.bounds);
        const ExactResult own = find(lines, camera), other = find_exactly(*cpp, lines, camera);
        EXPECT_GT(own.spans.size(), 100U);
        EXPECT_TRUE(equal(own.span_offsets, other.span_offsets)) << name;
        EXPECT_TRUE(equal(own.spans, other.spans)) << name;
    }
}

TEST_P(ExactTest, EveryFaceOfAScene) {
    const Scene scene = make_scene("house");
    const LineSet lines = extract_lines(scene.mesh);
    for (const float t : {0.1F, 0.6F}) {
        const Camera camera = make_camera(scene.view(t), {800, 600}, lines.bounds);
        expect_exact(compare_with_all_faces(lines, camera, find(lines, camera), 23), 2000);
    }
}

TEST_P(ExactTest, EveryFaceOfARoughFieldFromFarAndNear) {
    Random random{7};
    // By an angle: to --crease auto all of it is noise.
    const LineSet lines =
        extract_lines(height_field(random, 40, 6.0F), {.crease = std::numbers::pi_v<float> / 6});
    const glm::vec3 middle = 0.5F * (lines.bounds.min + lines.bounds.max);
    for (const float away : {1.0F, 3.0F, 40.0F}) {
        const Camera camera =
            make_camera({.eye = middle + away * glm::vec3{20, 25, 35}, .target = middle},
                        {700, 500}, lines.bounds);
        expect_exact(compare_with_all_faces(lines, camera, find(lines, camera), 11), 20);
    }
}

TEST_P(ExactTest, EveryFaceOfSlivers) {
    // Planes of such faces are ill defined on the screen, those beside a line too.
    Random random{11};
    Mesh mesh;
    for (int k = 0; k < 120; ++k) {
        const glm::vec3 a{random.between(5, 195), random.between(5, 195), random.between(-90, 90)};
        const glm::vec3 b{random.between(5, 195), random.between(5, 195), random.between(-90, 90)};
        const glm::vec2 way = glm::normalize(glm::vec2{b - a});
        const float height = random.between(0.01F, 0.3F);
        const glm::vec3 aside{-way.y * height, way.x * height, random.between(-20, 20)};
        add_triangle(mesh, a, b, glm::mix(a, b, random.between(0.2F, 0.8F)) + aside);
    }
    const LineSet lines = extract_lines(mesh);
    for (const Camera& camera : {square_camera(side), square_camera(side, 400, 100)}) {
        const Compared compared = compare_with_all_faces(lines, camera, find(lines, camera), 1);
        EXPECT_GT(compared.looked_at, 10'000);
        EXPECT_LT(compared.worst, exactly); // hundreds of ends a line: their rounding adds up
    }
}

// --- errors planted in kernels

/// Pixels that a device gets wrong of drawings whose answers are known.
double pixels_wrong(compute::Device& device) {
    double wrong = 0;
    const auto look = [&](Mesh mesh, glm::vec3 p, glm::vec3 q, const Camera& camera, float known) {
        add_polyline(mesh, std::array{p, q});
        const LineSet lines = extract_lines(mesh);
        const ExactResult result = find_exactly(device, lines, camera);
        const float found = visible_length(lines, result, p, q);
        wrong += std::max(0.0F, std::abs(found - known) - exactly);
        // Where, too; these faces know no near plane.
        if (camera.eye().w == 0)
            wrong +=
                std::max(0.0, compare_with_all_faces(lines, camera, result, 1).worst - exactly);
    };
    const Camera flat = square_camera(side), perspective = square_camera(side, 100, 5);
    Mesh panel;
    add_panel(panel, {0, 0}, {200, 200}, 0);
    look(panel, {40, 100, -1.5F}, {160, 100, -1.5F}, flat, 0);
    look(panel, {40, 100, -2e-3F}, {160, 100, -2e-3F}, flat, 0); // 5.7e-4 touch
    look(panel, {40, 100, -4e-4F}, {160, 100, -4e-4F}, flat, 120);
    look(panel, {40, 100, 30}, {160, 100, -60}, flat, 40);
    Mesh slanted;
    add_quad(slanted, {0, -500, 195}, {200, -500, -5}, {200, 700, -5}, {0, 700, 195});
    look(slanted, {20, 50, -40}, {180, 50, -40}, perspective, 80 / 1.4F);
    Mesh fence;
    for (int k = 0; k < 160; ++k) {
        const float x = 40 + 0.5F * static_cast<float>(k * 7 % 160);
        add_panel(fence, {x, 20}, {x + 0.25F, 180}, 0);
    }
    look(fence, {30, 100, -5}, {130, 100, -5}, flat, 60);
    // Outlines of round bars, which run along the sides of the faces beside them.
    const LineSet house = extract_lines(make_scene("house").mesh);
    const Camera camera =
        make_camera({.eye = {-30, 6, 22}, .target = {0, 3, 0}}, {1024, 768}, house.bounds);
    const ExactResult outlines = find_exactly(device, house, camera, mask_of(LineKind::silhouette));
    const Compared compared = compare_with_all_faces(house, camera, outlines, 1);
    return wrong + std::max(0.0, compared.worst - exactly);
}

struct Plant {
    const char *name, *file, *from, *to;
};

class PlantedInExact : public testing::TestWithParam<Plant> {};

TEST_P(PlantedInExact, IsSeen) {
    const PlantedError error{GetParam().file, GetParam().from, GetParam().to};
    EXPECT_GT(pixels_wrong(*own_opencl_devices().at(0).make()), 0.05);
}

TEST(PlantedNowhere, IsNotSeen) {
    EXPECT_EQ(pixels_wrong(*own_opencl_devices().at(0).make()), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Errors, PlantedInExact,
    testing::Values(
        Plant{"TwoPixelsBehindIsSeen", "visible.cl",
              "behind_p - args->contact, behind_q - args->contact",
              "behind_p - 2.0f, behind_q - 2.0f"},
        Plant{"TenTimesTheContact", "visible.cl",
              "behind_p - args->contact, behind_q - args->contact",
              "behind_p - 10.0f * args->contact, behind_q - 10.0f * args->contact"},
        Plant{"EndsOfAPieceSwapped", "visible.cl", "piece.s_a = s_a;\n    piece.s_b = s_b;",
              "piece.s_a = s_b;\n    piece.s_b = s_a;"},
        Plant{"AListCutShort", "tile_lists.cl", "(count + LA_GROUP - 1u) / LA_GROUP",
              "(count + LA_GROUP - 2u) / LA_GROUP"},
        Plant{"OwnFacesHide", "visible.cl", "behind_p - args->contact, behind_q - args->contact",
              "behind_p + args->contact, behind_q + args->contact"},
        Plant{"NothingIsTooCloseToCall", "visible.cl", "LA_ENTRY_DOUBT * LA_GROUP) + doubt",
              "LA_ENTRY_DOUBT * LA_GROUP) * 0.0f"},
        Plant{"NothingIsTooCloseToASide", "visible.cl", "#define CLOSE_TO_SIDE 0.01f",
              "#define CLOSE_TO_SIDE 0.0f"},
        Plant{"NoNearPlane", "visible.cl", "lists->faces[t].kind != FACE_CROSSES || !(*low",
              "true || !(*low"},
        Plant{"PartsBeyondThoseHeldAreLost", "visible.cl", "from = parts.end", "from = 1.0f"}),
    [](const auto& test) { return std::string{test.param.name}; });

} // namespace
} // namespace lineatlas::test
