// Parts that come and go. The picture is that of a new scene of the same parts.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "allocation_count.hpp"
#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/assembly.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "lineatlas/visibility.hpp"
#include "scene_cameras.hpp"
#include "test_meshes.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{480, 360};
constexpr LineOptions apart{.separate_objects = true};

const Mesh& house_mesh() {
    static const Mesh mesh = make_scene("house").mesh;
    return mesh;
}

const LineSet& house() {
    static const LineSet lines = extract_lines(house_mesh(), apart);
    return lines;
}

Camera camera(int which = 0) {
    return scene_cameras("house", size)[static_cast<std::size_t>(which)].camera;
}

Mesh block_mesh(glm::vec3 place, float side, std::optional<glm::vec3> color = {}) {
    Mesh mesh = cube();
    for (glm::vec3& p : mesh.positions) p = place + side * p;
    mesh.groups = {{.object = "block", .material = "paint", .color = color}};
    mesh.triangle_group.assign(mesh.triangles.size(), 0);
    return mesh;
}

LineSet block(glm::vec3 place, float side, std::optional<glm::vec3> color = {}) {
    return extract_lines(block_mesh(place, side, color), apart);
}

std::vector<std::uint32_t> some_objects() {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 1; i < house().objects.size(); i += 3) numbers.push_back(i);
    return numbers;
}

/// The house without some_objects() and with `added` in it, as one mesh.
Mesh changed_house(const Mesh& added) {
    Mesh mesh = house_mesh();
    const std::vector<std::uint32_t> gone = some_objects();
    const auto is_gone = [&](std::uint32_t group) {
        return std::ranges::any_of(gone, [&](std::uint32_t object) {
            return house().objects[object].name == mesh.groups[group].object;
        });
    };
    Mesh left = mesh;
    left.triangles.clear();
    left.triangle_group.clear();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (is_gone(mesh.triangle_group[i])) continue;
        left.triangles.push_back(mesh.triangles[i]);
        left.triangle_group.push_back(mesh.triangle_group[i]);
    }
    const auto vertices = static_cast<std::uint32_t>(left.positions.size());
    left.positions.insert(left.positions.end(), added.positions.begin(), added.positions.end());
    left.triangle_group.resize(left.triangles.size() + added.triangles.size(),
                               static_cast<std::uint32_t>(left.groups.size()));
    left.groups.push_back(added.groups.front());
    for (const glm::uvec3& t : added.triangles) left.triangles.push_back(t + vertices);
    return left;
}

FrameOptions options_of(Method method) {
    FrameOptions options{.method = method, .steady = false};
    options.style.fill.mode = FillMode::flat;
    if (method == Method::exact || method == Method::atlas)
        options.intervals = KeptIntervals::visible;
    return options;
}

std::size_t differing_pixels(const std::vector<std::uint8_t>& a,
                             const std::vector<std::uint8_t>& b) {
    // Where lines cross, their order decides which one is on top.
    constexpr int most = 8;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        const auto is_close = [&](std::size_t k) { return std::abs(a[i + k] - b[i + k]) <= most; };
        count += is_close(0) && is_close(1) && is_close(2) ? 0U : 1U;
    }
    return count;
}

struct Form {
    std::string name;
    Method method;
    StageForm depth;
    std::string device;
};

class Parts : public testing::TestWithParam<Form> {
  protected:
    DeviceOptions device() const { return {.compute = GetParam().device}; }
    std::vector<std::uint8_t> picture(Renderer& renderer, int which = 0) {
        FrameOptions options = options_of(GetParam().method);
        options.forms.depth = GetParam().depth;
        canvas_.clear({1, 1, 1, 1});
        stats_ = renderer.draw(camera(which), options, canvas_.framebuffer());
        return canvas_.read();
    }
    /// The picture of a new renderer.
    std::vector<std::uint8_t> picture_of(const LineSet& lines, int which = 0) {
        Renderer renderer{device()};
        renderer.set_lines(lines);
        return picture(renderer, which);
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{size};
    FrameStats stats_;
};

TEST_P(Parts, DrawAsOneLineSet) {
    Assembly scene;
    const std::vector<std::uint32_t> numbers = scene.add(house());
    ASSERT_EQ(numbers.size(), house().objects.size());
    Renderer renderer{device()};
    renderer.set_lines(scene);
    const auto drawn = picture(renderer), wanted = picture_of(house());
    EXPECT_LE(differing_pixels(drawn, wanted), wanted.size() / 4 / 1000);
    EXPECT_EQ(scene.lines().kind_counts, house().kind_counts);
    EXPECT_EQ(scene.lines().bounds.min, house().bounds.min);
    EXPECT_EQ(scene.lines().bounds.max, house().bounds.max);
}

TEST_P(Parts, ComeAndGo) {
    Assembly scene;
    scene.add(house());
    Renderer renderer{device()};
    renderer.set_lines(scene);
    const auto before = picture(renderer);
    const std::uint64_t bytes = stats_.mesh_bytes;
    for (const std::uint32_t object : some_objects()) scene.remove(object);
    const Mesh added = block_mesh({0.5F, 1, 0.5F}, 3, glm::vec3{1, 0, 0});
    const std::uint32_t number = scene.add(extract_lines(added, apart)).front();
    renderer.set_lines(scene);
    for (const int which : {0, 1}) {
        const auto drawn = picture(renderer, which);
        EXPECT_TRUE(equal(drawn, picture_of(scene.lines(), which)));
        const auto anew = picture_of(extract_lines(changed_house(added), apart), which);
        EXPECT_LE(differing_pixels(drawn, anew), anew.size() / 4 / 1000);
    }
    EXPECT_LE(stats_.mesh_bytes, bytes + bytes / 4) << "tables were made anew";
    const std::vector<Interval> found = LineVisibility{scene.lines(), device()}.find(camera());
    const LineObject& own = scene.lines().objects[number];
    float longest = 0;
    glm::vec2 middle{0}; // of the block's longest visible line, where no other one is near
    for (const Interval& interval : found) {
        const std::uint32_t vertex = scene.lines().segments[interval.segment].p;
        if (vertex - own.first_vertex >= own.vertex_count) continue;
        const glm::vec2 p{interval.start[0], interval.start[1]};
        const glm::vec2 q{interval.end[0], interval.end[1]};
        if (glm::distance(p, q) <= longest) continue;
        longest = glm::distance(p, q);
        middle = 0.5F * (p + q);
    }
    EXPECT_GT(longest, 5.0F);
    EXPECT_EQ(renderer.pick(camera(), middle, 0.5F)->object, number);

    scene.remove(number);
    const LineSet& lines = house();
    for (const std::uint32_t object : some_objects()) {
        Mesh part{.positions = house_mesh().positions,
                  .triangles = {},
                  .triangle_group = {},
                  .groups = house_mesh().groups,
                  .polylines = {}};
        for (std::size_t i = 0; i < house_mesh().triangles.size(); ++i) {
            const std::uint32_t group = house_mesh().triangle_group[i];
            if (part.groups[group].object != lines.objects[object].name) continue;
            part.triangles.push_back(house_mesh().triangles[i]);
            part.triangle_group.push_back(group);
        }
        scene.add(extract_lines(part));
    }
    renderer.set_lines(scene);
    EXPECT_LE(differing_pixels(before, picture(renderer)), before.size() / 4 / 1000);
}

TEST_P(Parts, OneByOneUntilTheTablesGrow) {
    Assembly scene;
    Renderer renderer{device()};
    std::vector<std::uint32_t> numbers;
    for (int i = 0; i < 60; ++i) {
        const auto x = static_cast<float>(i % 8), z = static_cast<float>(i / 8);
        numbers.push_back(scene
                              .add(block({x - 4, 0.2F * x, z - 4}, 0.5F,
                                         glm::vec3{0.1F * x, 0.1F * z, static_cast<float>(i % 3)}))
                              .front());
        if (i % 4 == 3) {
            scene.remove(numbers[numbers.size() - 2]);
            numbers.erase(numbers.end() - 2);
        }
        renderer.set_lines(scene);
        const auto drawn = picture(renderer);
        if (i % 7 != 0) continue;
        EXPECT_TRUE(equal(drawn, picture_of(scene.lines()))) << i;
    }
}

TEST_P(Parts, WithSmoothSilhouettesOneByOneToo) {
    Assembly scene;
    Renderer renderer{device()};
    std::vector<std::uint32_t> numbers;
    for (int i = 0; i < 16; ++i) {
        const auto x = static_cast<float>(i % 4), z = static_cast<float>(i / 4);
        const glm::vec3 place{2 * x - 4, 1 + 0.3F * x, 2 * z - 4};
        Mesh ball = sphere(2 + i % 3);
        for (glm::vec3& p : ball.positions) p = place + 0.9F * p;
        numbers.push_back(scene
                              .add(i % 4 == 2
                                       ? block(place, 0.5F)
                                       : extract_lines(ball, {.separate_objects = true,
                                                              .silhouettes = Silhouettes::smooth}))
                              .front());
        if (i % 4 == 3) {
            scene.remove(numbers[numbers.size() - 3]);
            numbers.erase(numbers.end() - 3);
        }
        renderer.set_lines(scene);
        const auto drawn = picture(renderer);
        if (i % 3 != 0) continue;
        EXPECT_TRUE(equal(drawn, picture_of(scene.lines()))) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(
    By, Parts,
    testing::Values(Form{"atlas", Method::atlas, StageForm::compute, "cpp"},
                    Form{"atlas_raster", Method::atlas, StageForm::raster, "cpp"},
                    Form{"atlas_opencl", Method::atlas, StageForm::automatic, "opencl"},
                    Form{"exact", Method::exact, StageForm::automatic, "cpp"},
                    Form{"exact_opencl", Method::exact, StageForm::automatic, "opencl"},
                    Form{"spine", Method::spine, StageForm::automatic, "cpp"},
                    Form{"item_buffer", Method::item_buffer, StageForm::automatic, "cpp"},
                    Form{"opengl", Method::opengl, StageForm::automatic, "cpp"}),
    [](const auto& info) { return info.param.name; });

class Assemblies : public testing::Test {
  protected:
    std::vector<std::uint8_t> picture(Renderer& renderer) {
        canvas_.clear({1, 1, 1, 1});
        renderer.draw(camera(), options_of(Method::atlas), canvas_.framebuffer());
        return canvas_.read();
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{size};
    Renderer renderer_{{.compute = "cpp"}};
};

TEST_F(Assemblies, WhatWasMovedOrHiddenStaysSo) {
    Assembly scene;
    scene.add(block({-2, 1, 0}, 1));
    scene.add(block({2, 1, 0}, 1));
    renderer_.set_lines(scene);
    std::vector<glm::mat4> transforms(2, glm::mat4{1});
    transforms[0] = glm::translate(glm::mat4{1}, {0, 2, 0});
    renderer_.set_transforms(transforms);
    renderer_.set_hidden(std::array{1U});
    scene.add(block({0, 0, 3}, 1));
    renderer_.set_lines(scene);
    const auto drawn = picture(renderer_);

    Renderer other{{.compute = "cpp"}};
    other.set_lines(scene.lines());
    transforms.emplace_back(1);
    other.set_transforms(transforms);
    other.set_hidden(std::array{1U});
    EXPECT_TRUE(equal(drawn, picture(other)));
    EXPECT_THROW(renderer_.set_transforms(std::span{transforms}.first(2)), UsageError);

    // The parts in their places are new.
    scene.remove(0);
    scene.remove(1);
    EXPECT_EQ(scene.add(block({-2, 1, 0}, 1)), std::vector<std::uint32_t>{0});
    EXPECT_EQ(scene.add(block({2, 1, 0}, 1)), std::vector<std::uint32_t>{1});
    renderer_.set_lines(scene);
    other.set_lines(scene.lines());
    EXPECT_TRUE(equal(picture(renderer_), picture(other)));
}

TEST_F(Assemblies, FramesAllocateNothingMore) {
    Assembly scene;
    scene.add(house());
    renderer_.set_lines(scene);
    const Camera seen = camera();
    const FrameOptions options;
    const auto frames = [&](Renderer& renderer) {
        for (int i = 0; i < 5; ++i) renderer.draw(seen, options, canvas_.framebuffer());
    };
    frames(renderer_);
    scene.remove(3);
    scene.add(block({0, 1, 0}, 2));
    renderer_.set_lines(scene);
    frames(renderer_);
    AllocationCount changed;
    frames(renderer_);
    const std::size_t of_parts = changed.stop();

    Renderer other{{.compute = "cpp"}};
    other.set_lines(house());
    frames(other);
    AllocationCount usual; // the threads of this device
    frames(other);
    EXPECT_LE(of_parts, usual.stop() * 11 / 10);
}

TEST_F(Assemblies, TakeAnotherDevice) {
    Assembly scene;
    scene.add(house());
    renderer_.set_lines(scene);
    picture(renderer_);
    scene.remove(2);
    renderer_.set_lines(scene);
    renderer_.set_device({.compute = "opencl"});
    scene.add(block({0, 1, 0}, 2));
    renderer_.set_lines(scene);
    Renderer other{{.compute = "opencl"}};
    other.set_lines(scene.lines());
    EXPECT_TRUE(equal(picture(renderer_), picture(other)));
}

TEST_F(Assemblies, GiveIntervalsWithoutARenderer) {
    Assembly scene;
    scene.add(house());
    scene.remove(1);
    scene.add(block({0, 1, 0}, 2));
    LineVisibility visibility{scene.lines(), {.compute = "cpp"}};
    renderer_.set_lines(scene);
    FrameOptions options = options_of(Method::exact);
    renderer_.draw(camera(), options, canvas_.framebuffer());
    const std::vector<Interval> found = visibility.find(camera());
    const std::vector<Interval> drawn = renderer_.read_intervals();
    EXPECT_GT(found.size(), 1000U);
    ASSERT_EQ(found.size(), drawn.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].segment, drawn[i].segment);
}

TEST_F(Assemblies, OfNothingDrawNothing) {
    Assembly scene;
    renderer_.set_lines(scene);
    const auto empty = picture(renderer_);
    const auto number = scene.add(block({0, 1, 0}, 2)).front();
    renderer_.set_lines(scene);
    EXPECT_FALSE(equal(empty, picture(renderer_)));
    scene.remove(number);
    renderer_.set_lines(scene);
    EXPECT_TRUE(equal(empty, picture(renderer_)));
}

TEST_F(Assemblies, RefuseWhatTheyDoNotHave) {
    Assembly scene;
    EXPECT_THROW(scene.remove(0), UsageError);
    const auto number = scene.add(block({0, 1, 0}, 2)).front();
    EXPECT_THROW(scene.remove(number + 1), UsageError);
    scene.remove(number);
    EXPECT_THROW(scene.remove(number), UsageError);
}

} // namespace
} // namespace lineatlas::test
