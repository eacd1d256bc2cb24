// Models that move: objects with matrices, and shapes that change. The device's tables are those of
// a model that was made at the new places.

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "compare.hpp"
#include "compute/cpp/cpp_device.hpp"
#include "core/clusters.hpp"
#include "core/objects.hpp"
#include "devices.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "moved_tables.hpp"
#include "scene_cameras.hpp"
#include "test_meshes.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{480, 360};
constexpr LineOptions apart{.separate_objects = true};

glm::mat4 turned_about(glm::vec3 centre, float angle) {
    return glm::translate(glm::mat4{1}, centre) *
           glm::rotate(glm::mat4{1}, angle, glm::normalize(glm::vec3{0.3F, 1, 0.2F})) *
           glm::translate(glm::mat4{1}, -centre);
}

glm::vec3 middle_of(const LineSet& lines, const LineObject& object) {
    glm::vec3 sum{0};
    for (std::uint32_t i = 0; i < object.vertex_count; ++i) {
        sum += lines.vertices[object.first_vertex + i];
    }
    return sum / static_cast<float>(std::max(object.vertex_count, 1U));
}

/// Matrices that move every object but the first, and mirror some.
std::vector<glm::mat4> scattered(const LineSet& lines, float amount) {
    std::vector<glm::mat4> result(lines.objects.size(), glm::mat4{1});
    for (std::size_t i = 1; i < result.size(); ++i) {
        const auto phase = static_cast<float>(i);
        const glm::vec3 middle = middle_of(lines, lines.objects[i]);
        result[i] = turned_about(middle, amount * std::sin(phase));
        result[i][3] += glm::vec4{amount * std::cos(phase), 0.3F * amount, 0, 0};
        if (i % 5 == 0) {
            result[i] = result[i] * glm::translate(glm::mat4{1}, middle) *
                        glm::scale(glm::mat4{1}, {-1, 1, 1}) *
                        glm::translate(glm::mat4{1}, -middle);
        }
    }
    return result;
}

const LineSet& office() {
    static const LineSet lines = extract_lines(make_scene("office").mesh, apart);
    return lines;
}

Camera office_camera(int which) {
    return scene_cameras("office", size)[static_cast<std::size_t>(which)].camera;
}

LineSet made_there(LineSet lines, std::span<const glm::mat4> transforms) {
    move_objects(lines, transforms);
    return lines;
}

/// Two cubes whose sides touch, as two objects.
Mesh two_cubes() {
    Mesh mesh = cube();
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    const std::size_t triangles = mesh.triangles.size();
    Bounds box = bounds_of(mesh);
    for (std::uint32_t i = 0; i < count; ++i) {
        mesh.positions.push_back(mesh.positions[i] + glm::vec3{box.max.x - box.min.x, 0, 0});
    }
    for (std::size_t i = 0; i < triangles; ++i) {
        mesh.triangles.push_back(mesh.triangles[i] + count);
    }
    mesh.triangle_object.assign(triangles, 0);
    mesh.triangle_object.resize(2 * triangles, 1);
    return mesh;
}

TEST(Objects, NothingIsWeldedBetweenThem) {
    const Mesh mesh = two_cubes();
    EXPECT_EQ(extract_lines(mesh).vertices.size(), 12U);
    EXPECT_TRUE(extract_lines(mesh).objects.empty());
    const LineSet lines = extract_lines(mesh, apart);
    ASSERT_EQ(lines.objects.size(), 2U);
    EXPECT_EQ(lines.objects[0].vertex_count, 8U);
    EXPECT_EQ(lines.objects[1].first_vertex, 8U);
    EXPECT_EQ(lines.objects[1].vertex_count, 8U);
    EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], 24U);
    for (std::size_t i = 0; i < lines.vertices.size(); ++i) {
        EXPECT_EQ(lines.vertices[i], mesh.positions[lines.vertex_sources[i]]);
    }
}

TEST(Objects, ShareTheIndicesOfTheirMesh) {
    Mesh mesh = two_cubes();
    mesh = Mesh{.positions = mesh.positions,
                .triangles = mesh.triangles,
                .triangle_group = {},
                .groups = {},
                .polylines = {{0, 1}, {2, 3}},
                .triangle_object = mesh.triangle_object};
    // The second cube uses corners of the first. So one position has two vertices.
    for (std::size_t i = mesh.triangles.size() / 2; i < mesh.triangles.size(); ++i) {
        mesh.triangles[i] -= 8U;
    }
    const LineSet lines = extract_lines(mesh, apart);
    ASSERT_EQ(lines.objects.size(), 3U) << "and the lines of the file";
    EXPECT_EQ(lines.objects[1].vertex_count, 8U);
    EXPECT_EQ(lines.objects[2].vertex_count, 4U);
    mesh.polyline_object = {0, 1};
    EXPECT_EQ(extract_lines(mesh, apart).objects.size(), 2U);
}

TEST(Objects, AreGroupsOfOneName) {
    Mesh mesh = two_cubes();
    mesh.triangle_object.clear();
    mesh.groups = {{.object = "left", .material = "a"},
                   {.object = "right", .material = "a"},
                   {.object = "left", .material = "b"}};
    mesh.triangle_group.assign(12, 0);
    mesh.triangle_group[3] = 2;
    mesh.triangle_group.resize(24, 1);
    const LineSet lines = extract_lines(mesh, apart);
    ASSERT_EQ(lines.objects.size(), 2U);
    EXPECT_EQ(lines.objects[0].name, "left");
    EXPECT_EQ(lines.objects[1].name, "right");
    EXPECT_EQ(lines.objects[0].vertex_count, 8U);
}

TEST(Objects, NumbersThatDoNotFitAreRefused) {
    Mesh mesh = two_cubes();
    mesh.triangle_object.pop_back();
    EXPECT_THROW(extract_lines(mesh, apart), UsageError);
    mesh.triangle_object.push_back(0xFFFFFFFF);
    EXPECT_THROW(extract_lines(mesh, apart), UsageError);
}

TEST(Objects, LieInClustersOfTheirOwn) {
    const LineSet& lines = office();
    const TriangleClusters parts =
        build_clusters(lines.vertices, lines.triangles, 64, lines.objects);
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < parts.clusters.size(); ++i) {
        const LineObject& object = lines.objects[parts.objects[i]];
        const Cluster& cluster = parts.clusters[i];
        triangles += cluster.count;
        for (std::uint32_t k = cluster.first; k < cluster.first + cluster.count; ++k) {
            ASSERT_GE(parts.triangles[k].x, object.first_vertex);
            ASSERT_LT(parts.triangles[k].x, object.first_vertex + object.vertex_count);
        }
    }
    EXPECT_EQ(triangles, lines.triangles.size());
}

class TransformStage : public testing::TestWithParam<TestDevice> {};

TEST_P(TransformStage, IsTheSameBitByBit) {
    const LineSet& lines = office();
    const std::vector<glm::mat4> transforms = scattered(lines, 0.4F);
    DeviceStages cpp{compute::make_cpp_device()}, other{GetParam().make()};
    const MovedTables expected = moved_on(cpp.stages, lines, transforms);
    const MovedTables seen = moved_on(other.stages, lines, transforms);
    EXPECT_TRUE(same_bits(expected.vertices, seen.vertices));
    EXPECT_TRUE(same_bits(expected.vertices, seen.drawn));
    EXPECT_TRUE(same_bits(expected.clusters, seen.clusters));
    EXPECT_TRUE(same_bits(expected.bounds, seen.bounds));
    EXPECT_TRUE(same_bits(expected.ranges, seen.ranges));

    const LineSet there = made_there(lines, transforms);
    EXPECT_TRUE(same_bits(there.vertices, seen.vertices));
    EXPECT_GT(std::ranges::count(seen.ranges, 0U), 0);
    EXPECT_GT(std::ranges::count(seen.ranges, 0xFFFF0000U), 0);
    // Boxes hold their triangles. Exact boxes are those of a model made at these places.
    const TriangleClusters parts =
        build_clusters(lines.vertices, lines.triangles, 64, lines.objects);
    for (std::size_t i = 0; i < parts.clusters.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_LE(seen.clusters[i].low[axis], seen.bounds[i].low[axis]);
            ASSERT_GE(seen.clusters[i].high[axis], seen.bounds[i].high[axis]);
        }
    }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(TransformStage);
INSTANTIATE_TEST_SUITE_P(OnDevice, TransformStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

struct MovingCase {
    const char* device;
    Method method;
};

class Moving : public testing::TestWithParam<MovingCase> {
  protected:
    DeviceOptions device() const { return {.compute = GetParam().device}; }
    FrameOptions frame() const { return {.method = GetParam().method, .steady = false}; }

    std::vector<std::uint8_t> picture(Renderer& renderer, const Camera& camera,
                                      const FrameOptions& options) {
        canvas_.clear({1, 1, 1, 1});
        stats_ = renderer.draw(camera, options, canvas_.framebuffer());
        return canvas_.read();
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{size};
    FrameStats stats_;
};

/// Expects that intervals agree to `pixels`. Returns their number.
std::size_t expect_close(const std::vector<Interval>& a, const std::vector<Interval>& b,
                         float pixels) {
    EXPECT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        EXPECT_EQ(a[i].segment, b[i].segment);
        for (int k = 0; k < 2; ++k) {
            EXPECT_NEAR(a[i].start[k], b[i].start[k], pixels);
            EXPECT_NEAR(a[i].end[k], b[i].end[k], pixels);
        }
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[i].start_world[k], b[i].start_world[k], 1e-4F);
        if (testing::Test::HasFailure()) break;
    }
    return a.size();
}

/// The number of pixels that differ between two pictures of four bytes a pixel.
std::size_t differing_pixels(const std::vector<std::uint8_t>& a,
                             const std::vector<std::uint8_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); i += 4)
        count += std::equal(&a[i], &a[i] + 4, &b[i]) ? 0U : 1U;
    return count + (a.size() == b.size() ? 0U : a.size());
}

TEST_P(Moving, ObjectsAreWhereAModelWouldBeThatIsMadeThere) {
    const LineSet& lines = office();
    FrameOptions options = frame();
    options.intervals = KeptIntervals::visible;
    Renderer moving{device()}, still{device()};
    moving.set_lines(lines);
    for (const float amount : {0.1F, 0.5F}) {
        const std::vector<glm::mat4> transforms = scattered(lines, amount);
        moving.set_transforms(transforms);
        still.set_lines(made_there(lines, transforms));
        for (const int view : {0, 1}) {
            const Camera camera = office_camera(view);
            const auto drawn = picture(moving, camera, options);
            const auto wanted = picture(still, camera, options);
            if (options.method == Method::exact) {
                EXPECT_TRUE(equal(drawn, wanted));
                EXPECT_GT(expect_close(moving.read_intervals(), still.read_intervals(), 1e-3F),
                          1000U);
                continue;
            }
            // Where faces of two boxes coincide, a texel may show either of them. Their order in
            // the depth pass is that of clusters, and a model made at other places has other
            // clusters.
            EXPECT_LE(differing_pixels(drawn, wanted), wanted.size() / 4 / 10000);
            EXPECT_NEAR(static_cast<double>(moving.read_intervals().size()) /
                            static_cast<double>(still.read_intervals().size()),
                        1, 2e-4);
        }
    }
}

TEST_P(Moving, WhatIsHiddenIsLeftOutAndNothingElse) {
    if (GetParam().method == Method::exact) GTEST_SKIP() << "draws no triangles";
    const LineSet& lines = office();
    Renderer renderer{device()};
    renderer.set_lines(lines);
    const Camera camera = office_camera(1);
    FrameOptions options{.steady = false};
    std::uint32_t fewest = 0xFFFFFFFF;
    for (int frame = 0; frame < 4; ++frame) {
        renderer.set_transforms(scattered(lines, 0.2F * static_cast<float>(frame)));
        options.cull_hidden = true;
        const auto culled = picture(renderer, camera, options);
        fewest = std::min(fewest, stats_.triangles_drawn);
        options.cull_hidden = false;
        EXPECT_TRUE(equal(culled, picture(renderer, camera, options)));
    }
    EXPECT_LT(fewest, lines.triangles.size() / 2);
}

TEST_P(Moving, BackToWhereItWasIsThePictureThatWas) {
    const LineSet& lines = office();
    Renderer renderer{device()};
    renderer.set_lines(lines);
    const Camera camera = office_camera(0);
    const FrameOptions options = frame();
    const auto still = picture(renderer, camera, options);
    renderer.set_transforms(scattered(lines, 0.5F));
    EXPECT_FALSE(equal(still, picture(renderer, camera, options)));
    renderer.set_transforms(std::vector<glm::mat4>(lines.objects.size(), glm::mat4{1}));
    EXPECT_TRUE(equal(still, picture(renderer, camera, options)));
}

TEST_P(Moving, AShapeMayChange) {
    const LineSet& lines = office();
    LineSet bent = lines;
    for (glm::vec3& v : bent.vertices) v.y += 0.4F * std::sin(0.5F * v.x);
    for (glm::vec3& v : bent.vertices) bent.bounds.max = glm::max(bent.bounds.max, v);
    for (glm::vec3& v : bent.vertices) bent.bounds.min = glm::min(bent.bounds.min, v);
    const FrameOptions options = frame();
    Renderer moving{device()}, still{device()};
    moving.set_lines(lines);
    still.set_lines(bent);
    const Camera camera = office_camera(0);
    const auto before = picture(moving, camera, options);
    const auto half = static_cast<std::uint32_t>(bent.vertices.size() / 2);
    moving.set_positions(0, std::span{bent.vertices}.first(half));
    moving.set_positions(half, std::span{bent.vertices}.subspan(half));
    const auto after = picture(moving, camera, options);
    EXPECT_FALSE(equal(before, after));
    // For the exact method, the distance of touching bodies is a share of the model's size as it
    // was set.
    const auto expect_same = [&](const std::vector<std::uint8_t>& a,
                                 const std::vector<std::uint8_t>& b) {
        if (GetParam().method == Method::exact)
            EXPECT_EQ(compare_bytes(a, b).beyond, 0U);
        else
            EXPECT_LE(differing_pixels(a, b), a.size() / 4 / 2000); // where faces coincide
    };
    expect_same(after, picture(still, camera, options));
    const std::vector<glm::mat4> transforms = scattered(lines, 0.3F);
    moving.set_transforms(transforms);
    still.set_lines(made_there(bent, transforms));
    expect_same(picture(moving, camera, options), picture(still, camera, options));
}

TEST_P(Moving, GoesOnOnAnotherDevice) {
    const LineSet& lines = office();
    Renderer renderer{device()};
    renderer.set_lines(lines);
    renderer.set_transforms(scattered(lines, 0.3F));
    const Camera camera = office_camera(0);
    const FrameOptions options = frame();
    const auto before = picture(renderer, camera, options);
    renderer.set_device({.compute = device().compute, .interop = "copy"});
    EXPECT_TRUE(equal(before, picture(renderer, camera, options)));
}

INSTANTIATE_TEST_SUITE_P(
    On, Moving,
    testing::Values(MovingCase{"opencl", Method::atlas}, MovingCase{"cpp", Method::atlas},
                    MovingCase{"opencl", Method::exact}, MovingCase{"cpp", Method::exact}),
    [](const auto& info) {
        return std::string{info.param.device} + (info.param.method == Method::exact ? "Exact" : "");
    });

TEST(MovingRenderer, EveryStageIsComparedAndEqual) {
    const gl::HeadlessContext context;
    gl::Canvas canvas{size};
    Renderer renderer{{.compare_with = "cpp"}};
    const LineSet& lines = office();
    renderer.set_lines(lines);
    for (const float amount : {0.0F, 0.01F, 0.5F}) { // slow movement, then a jump
        renderer.set_transforms(scattered(lines, amount));
        EXPECT_NO_THROW(renderer.draw(office_camera(0), {}, canvas.framebuffer()));
    }
    renderer.set_positions(0, lines.vertices);
    EXPECT_NO_THROW(renderer.draw(office_camera(0), {}, canvas.framebuffer()));
}

TEST(MovingRenderer, WhatJumpsIsNotAveraged) {
    const gl::HeadlessContext context;
    gl::Canvas canvas{size};
    const auto draw = [&](Renderer& renderer, bool steady) {
        canvas.clear({1, 1, 1, 1});
        FrameOptions options{.cull_hidden = false, .steady = steady};
        renderer.draw(office_camera(0), options, canvas.framebuffer());
        return renderer.read_samples();
    };
    const LineSet& lines = office();
    Renderer steady, plain;
    for (Renderer* renderer : {&steady, &plain}) renderer->set_lines(lines);
    draw(steady, true);
    // Some objects move; the farthest of them must move by more than four pixels.
    std::vector<glm::mat4> transforms(lines.objects.size(), glm::mat4{1});
    std::vector<bool> has_moved(lines.vertices.size());
    for (std::size_t i = 1; i < transforms.size(); i += 4) {
        transforms[i] = glm::translate(glm::mat4{1}, {6, 0, 0});
        const LineObject& object = lines.objects[i];
        std::fill_n(has_moved.begin() + object.first_vertex, object.vertex_count, true);
    }
    for (Renderer* renderer : {&steady, &plain}) renderer->set_transforms(transforms);
    const Renderer::Samples averaged = draw(steady, true), expected = draw(plain, false);
    ASSERT_EQ(averaged.offsets, expected.offsets);
    std::size_t checked = 0, others = 0;
    for (std::size_t i = 0; i < lines.segments.size(); ++i) {
        const bool moved = has_moved[lines.segments[i].p];
        for (std::uint32_t j = expected.offsets[i]; j < expected.offsets[i + 1]; ++j) {
            if (moved) {
                ASSERT_EQ(averaged.alpha[j], expected.alpha[j]) << "segment " << i;
                ++checked;
            } else if (averaged.alpha[j] != expected.alpha[j]) {
                ++others;
            }
        }
    }
    EXPECT_GT(checked, 1000U);
    EXPECT_GT(others, 0U) << "nothing was averaged: the test would prove nothing";
}

TEST(MovingRenderer, WhatMakesNoSenseIsRefused) {
    const gl::HeadlessContext context;
    gl::Canvas canvas{{64, 48}};
    Renderer renderer;
    const std::vector<glm::mat4> one(1, glm::mat4{1});
    EXPECT_THROW(renderer.set_transforms(one), UsageError) << "no lines yet";
    const LineSet lines = extract_lines(two_cubes(), apart);
    renderer.set_lines(lines);
    EXPECT_THROW(renderer.set_transforms(one), UsageError);
    std::vector<glm::mat4> two(2, glm::mat4{1});
    EXPECT_NO_THROW(renderer.set_transforms(two));
    const auto refused = [&](const glm::mat4& matrix) {
        two[1] = matrix;
        EXPECT_THROW(renderer.set_transforms(two), UsageError);
    };
    glm::mat4 matrix{1};
    matrix[1][1] = std::numeric_limits<float>::quiet_NaN();
    refused(matrix);
    matrix[1][1] = std::numeric_limits<float>::infinity();
    refused(matrix);
    matrix[1][1] = 0;
    refused(matrix);
    matrix = glm::mat4{1};
    matrix[0] = matrix[1];
    refused(matrix);
    matrix = glm::mat4{1};
    matrix[2][3] = 0.1F;
    refused(matrix);
    two[1] = glm::scale(glm::mat4{1}, {1e-5F, -1e-5F, 1e-5F});
    EXPECT_NO_THROW(renderer.set_transforms(two));
    const std::vector<glm::vec3> points(17);
    EXPECT_THROW(renderer.set_positions(0, points), UsageError);
    EXPECT_THROW(renderer.set_positions(17, std::span{points}.first(1)), UsageError);
    EXPECT_THROW(renderer.set_positions(0xFFFFFFFF, std::span{points}.first(2)), UsageError);
    const std::vector<glm::vec3> endless(1, glm::vec3{std::numeric_limits<float>::infinity()});
    EXPECT_THROW(renderer.set_positions(0, endless), UsageError);
    const Camera camera = office_camera(0);
    EXPECT_NO_THROW(renderer.draw(camera, {}, canvas.framebuffer()));
}

} // namespace
} // namespace lineatlas::test
