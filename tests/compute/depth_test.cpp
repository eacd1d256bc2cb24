// depth: triangles by hand, of which it is known what they cover, and how near they are there.

#include <algorithm>

#include <glm/ext/matrix_clip_space.hpp>

#include "depth_model.hpp"
#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

/// Corners in the window: texels from the lower left, and window depth.
using Corners = std::vector<glm::vec3>;

class DepthStage : public StageTest {
  protected:
    /// Every three corners are a triangle, in a picture of `size` texels.
    DrawnDepth draw(const Corners& corners, glm::ivec2 size = hand_size,
                    std::uint32_t cluster_size = 64) {
        return draw_part(corners, size, {{0, 0}, size}, cluster_size);
    }
    DrawnDepth draw_part(const Corners& corners, glm::ivec2 size, const TexelRectangle& part,
                         std::uint32_t cluster_size = 64) {
        std::vector<glm::vec3> vertices;
        std::vector<glm::uvec3> triangles;
        for (const glm::vec3& corner : corners) {
            vertices.emplace_back(glm::vec2{corner} / glm::vec2{size} * 2.0F - 1.0F,
                                  corner.z * 2 - 1);
            const auto last = static_cast<std::uint32_t>(vertices.size());
            if (last % 3 == 0) triangles.emplace_back(last - 3, last - 2, last - 1);
        }
        return model(vertices, triangles, {glm::mat4{1}, size, part}, cluster_size);
    }
    DrawnDepth model(const std::vector<glm::vec3>& vertices,
                     const std::vector<glm::uvec3>& triangles, const DepthWanted& wanted,
                     std::uint32_t cluster_size = 64) {
        return DepthModel{device(), vertices, triangles, cluster_size}.draw(stages(), wanted);
    }
};
std::vector<TestDevice> devices_in_both_forms() {
    std::vector<TestDevice> devices = test_devices();
    devices.push_back(cpp_as_gpu());
    return devices;
}
INSTANTIATE_TEST_SUITE_P(OnDevice, DepthStage, testing::ValuesIn(devices_in_both_forms()),
                         [](const auto& info) { return info.param.name; });

float at(const DrawnDepth& drawn, int x, int y, glm::ivec2 size = hand_size) {
    return drawn.texels[static_cast<std::size_t>(y * size.x + x)];
}

/// Two triangles that share the diagonal.
Corners rectangle(glm::vec2 low, glm::vec2 high, float z) {
    return {{low.x, low.y, z}, {high.x, low.y, z},  {high.x, high.y, z},
            {low.x, low.y, z}, {high.x, high.y, z}, {low.x, high.y, z}};
}

Corners operator+(Corners a, const Corners& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

void expect_rectangle(const DrawnDepth& drawn, glm::ivec2 low, glm::ivec2 high, float inside) {
    for (int y = 0; y < hand_size.y; ++y) {
        for (int x = 0; x < hand_size.x; ++x) {
            const bool in = x >= low.x && x <= high.x && y >= low.y && y <= high.y;
            ASSERT_NEAR(at(drawn, x, y), in ? inside : 1.0F, 1e-6) << x << ", " << y;
        }
    }
}

TEST_P(DepthStage, CoversTexelsWhoseMiddleIsInside) {
    expect_rectangle(draw(rectangle({2.4F, 3.4F}, {10.6F, 7.6F}, 0.25F)), {2, 3}, {10, 7}, 0.25F);
    expect_rectangle(draw(rectangle({2.6F, 3.6F}, {10.4F, 7.4F}, 0.25F)), {3, 4}, {9, 6}, 0.25F);
}

TEST_P(DepthStage, AnEdgeThroughMiddlesBelongsToTheLeftAndTheTop) {
    expect_rectangle(draw(rectangle({2.5F, 3.5F}, {10.5F, 7.5F}, 0.25F)), {2, 4}, {9, 7}, 0.25F);
}

TEST_P(DepthStage, BothSidesOfAFaceCount) {
    Corners back = rectangle({2.4F, 3.4F}, {10.6F, 7.6F}, 0.25F);
    for (std::size_t i = 0; i < back.size(); i += 3) std::swap(back[i], back[i + 1]);
    expect_rectangle(draw(back), {2, 3}, {10, 7}, 0.25F);
}

TEST_P(DepthStage, FacesOfEveryWidthAreFilledWhole) {
    for (const float width : {1.0F, 7.0F, 8.0F, 9.0F, 15.0F, 16.0F, 17.0F, 40.0F, 63.0F}) {
        for (const float left : {0.0F, 0.2F, 1.0F}) {
            const auto drawn = draw(rectangle({left, 5}, {left + width, 60}, 0.5F));
            expect_rectangle(drawn, {0.5F + left, 5}, {static_cast<int>(left + width - 0.5F), 59},
                             0.5F);
        }
    }
}

TEST_P(DepthStage, TheNearestFaceCountsInWhateverOrder) {
    const Corners near = rectangle({8, 8}, {24, 24}, 0.25F),
                  far = rectangle({0, 0}, {64, 64}, 0.5F);
    for (const Corners& both : {near + far, far + near}) {
        for (const std::uint32_t cluster_size : {2U, 64U}) {
            const auto drawn = draw(both, hand_size, cluster_size);
            EXPECT_FLOAT_EQ(at(drawn, 8, 8), 0.25F);
            EXPECT_FLOAT_EQ(at(drawn, 23, 23), 0.25F);
            EXPECT_FLOAT_EQ(at(drawn, 24, 23), 0.5F);
            EXPECT_FLOAT_EQ(at(drawn, 63, 63), 0.5F);
        }
    }
}

/// The window depth of a plane at a texel's middle.
double plane_at(const Corners& corners, int x, int y) {
    const glm::dvec3 a{corners[0]}, b{corners[1]}, c{corners[2]};
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    return a.z - (normal.x * (x + 0.5 - a.x) + normal.y * (y + 0.5 - a.y)) / normal.z;
}

TEST_P(DepthStage, DepthIsThatOfThePlaneThroughTheCornersThemselves) {
    // Corners off the grid, of a slope that a 1/256 of a texel would show in.
    for (const float size : {3.0F, 12.0F, 30.0F, 60.0F}) {
        const Corners corners{{1.2371F, 1.1113F, 0.1F},
                              {1.2371F + size, 2.3717F, 0.7F},
                              {2.7719F, 1.3331F + size, 0.3F}};
        const auto drawn = draw(corners);
        int covered = 0;
        for (int y = 0; y < hand_size.y; ++y) {
            for (int x = 0; x < hand_size.x; ++x) {
                if (at(drawn, x, y) == 1.0F) continue;
                ++covered;
                ASSERT_NEAR(at(drawn, x, y), plane_at(corners, x, y), 2e-6) << x << ", " << y;
            }
        }
        EXPECT_NEAR(covered, size * size / 2, 2.5 * size);
    }
}

/// A floor a unit below the eye that goes on behind it, and a view that it fills the lower half of.
struct Floor {
    std::vector<glm::vec3> vertices{
        {-900, -1, 90}, {900, -1, 90}, {900, -1, -900}, {-900, -1, -900}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    static constexpr float near = 0.5F, far = 100;
    glm::mat4 clip_from_world = glm::perspective(glm::radians(90.0F), 1.0F, near, far);
};

TEST_P(DepthStage, WhatCrossesNearAndFarPlaneAndTheSidesIsCutThere) {
    const Floor floor;
    for (const int side : {64, 300}) {
        const glm::ivec2 size{side, side};
        const auto drawn =
            model(floor.vertices, floor.triangles, {floor.clip_from_world, size, {{0, 0}, size}});
        for (int y = 0; y < side; ++y) {
            const double down = 1 - (y + 0.5) / (0.5 * side); // of the ray, per unit forward
            const double distance = 1 / down;
            const bool seen = down > 0 && distance > Floor::near && distance < Floor::far;
            const double depth =
                (1 / Floor::near - 1 / distance) / (1 / Floor::near - 1 / Floor::far);
            for (int x = 0; x < side; ++x)
                ASSERT_NEAR(at(drawn, x, y, size), seen ? depth : 1.0, 2e-6) << x << ", " << y;
        }
    }
}

/// Many faces of all sizes and slopes, from a fixed seed.
Corners strewn(int count, glm::ivec2 size) {
    std::uint32_t state = 7;
    const auto random = [&state] {
        state = state * 1664525U + 1013904223U;
        return static_cast<float>(state >> 8U) / static_cast<float>(1U << 24U);
    };
    Corners corners;
    for (int i = 0; i < count; ++i) {
        const float extent = random() < 0.1F ? 400.0F : 30.0F;
        const glm::vec2 middle = glm::vec2{random(), random()} * glm::vec2{size};
        for (int k = 0; k < 3; ++k) {
            corners.emplace_back(middle + extent * glm::vec2{random() - 0.5F, random() - 0.5F},
                                 0.1F + 0.8F * random());
        }
    }
    return corners;
}

TEST_P(DepthStage, OfEverySizeThePyramidIsThatOfItsStage) {
    for (const glm::ivec2 size : {glm::ivec2{1, 1}, {3, 90}, {17, 5}, {256, 256}, {300, 270}}) {
        const auto drawn = draw(strewn(40, size), size);
        const auto depth = put(drawn.texels);
        const auto tiles = device().allocate(drawn.tiles.size() * sizeof(float));
        stages().pyramid(*depth, size, *tiles);
        EXPECT_TRUE(equal(drawn.tiles, get<float>(*tiles, drawn.tiles.size())));
    }
}

TEST_P(DepthStage, APartCoversWhatTheWholeDoes) {
    const glm::ivec2 size{300, 270};
    const Corners corners = strewn(60, size);
    const auto whole = draw(corners, size);
    const TexelRectangle part{{37, 101}, {293, 270}};
    const auto own = draw_part(corners, size, part);
    const glm::ivec2 part_size = part.size();
    for (int y = 0; y < part_size.y; ++y) {
        for (int x = 0; x < part_size.x; ++x) {
            const float before = at(whole, x + part.low.x, y + part.low.y, size);
            ASSERT_EQ(at(own, x, y, part_size) == 1, before == 1) << x << ", " << y;
            // Where a tile begins decides how a plane is rounded.
            ASSERT_NEAR(at(own, x, y, part_size), before, 2e-6) << x << ", " << y;
        }
    }
}

TEST_P(DepthStage, SmallClustersAndLargeOnesGiveTheSame) {
    const glm::ivec2 size{300, 270};
    const Corners corners = strewn(120, size);
    EXPECT_TRUE(equal(draw(corners, size, 1).texels, draw(corners, size, 64).texels));
}

TEST_P(DepthStage, ClustersThatAreHiddenOrOutsideAreNotSeen) {
    const Corners wall = rectangle({0, 0}, {64, 64}, 0.25F);
    const Corners behind = rectangle({8, 8}, {24, 24}, 0.5F);
    const Corners outside = rectangle({80, 8}, {90, 24}, 0.1F);
    const auto drawn = draw(wall + behind + outside, hand_size, 2);
    ASSERT_EQ(drawn.seen.size(), 3U);
    EXPECT_EQ(std::ranges::count(drawn.seen, 1), 1);
    EXPECT_EQ(std::ranges::count(drawn.seen, 0), 2);
}

TEST_P(DepthStage, WithoutTrianglesAllIsFar) {
    const auto drawn = model({{0, 0, 0}}, {}, {glm::mat4{1}, {40, 20}, {{0, 0}, {40, 20}}});
    EXPECT_TRUE(equal(drawn.texels, std::vector(800, 1.0F)));
    EXPECT_TRUE(equal(drawn.tiles, std::vector(6, 1.0F)));
}

/// As many triangles as texels: whose number stands in a texel is whose depth does.
TEST_P(DepthStage, NumbersAreThoseOfTheTrianglesThatTexelsShow) {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    // Sheets of two triangles over each other, of which later ones lie farther to the upper right;
    // the last goes through the near plane.
    for (std::uint32_t i = 0; i < 40; ++i) {
        const float low = -1.2F + 0.04F * static_cast<float>(i);
        const float z = 0.9F - 0.04F * static_cast<float>(i % 13);
        for (const glm::vec2 corner :
             {glm::vec2{0, 0}, glm::vec2{0.5F, 0}, glm::vec2{0.5F, 0.6F}, glm::vec2{0, 0.6F}}) {
            vertices.emplace_back(corner + low, i == 39 && corner.x > 0 ? -2.0F : z);
        }
        triangles.emplace_back(4 * i, 4 * i + 1, 4 * i + 2);
        triangles.emplace_back(4 * i, 4 * i + 2, 4 * i + 3);
    }
    for (const std::uint32_t cluster_size : {1U, 7U, 64U}) {
        const DrawnDepth all =
            model(vertices, triangles, {glm::mat4{1}, hand_size, {{0, 0}, hand_size}, true},
                  cluster_size);
        std::size_t shown = 0;
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            const DrawnDepth one =
                model(vertices, {triangles[i]}, {glm::mat4{1}, hand_size, {{0, 0}, hand_size}});
            for (std::size_t t = 0; t < all.texels.size(); ++t) {
                if (all.numbers[t] != i) continue;
                ++shown;
                EXPECT_NEAR(one.texels[t], all.texels[t], 1e-6) << "texel " << t;
            }
        }
        for (std::size_t t = 0; t < all.texels.size(); ++t) {
            EXPECT_EQ(all.numbers[t] == LA_NO_FACE, all.texels[t] == 1) << "texel " << t;
            if (all.numbers[t] == LA_NO_FACE) ++shown;
        }
        EXPECT_EQ(shown, all.texels.size());
    }
}

/// Who asks for numbers alone gets the same ones, and no depth is written; on devices that draw in
/// several launches, too, each of which goes on from the depth so far.
TEST_P(DepthStage, NumbersCanBeHadWithoutDepth) {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t i = 0; i < 30; ++i) {
        const float low = -1 + 0.05F * static_cast<float>(i);
        const float z = 0.8F - 0.05F * static_cast<float>(i % 11);
        vertices.insert(vertices.end(),
                        {{low, low, z}, {low + 0.6F, low, z}, {low, low + 0.7F, -z}});
        triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    DepthWanted wanted{glm::mat4{1}, hand_size, {{0, 0}, hand_size}, true};
    const DrawnDepth both = model(vertices, triangles, wanted, 3);
    wanted.texels = false;
    const DrawnDepth alone = model(vertices, triangles, wanted, 3);
    EXPECT_EQ(alone.numbers, both.numbers);
    EXPECT_EQ(alone.tiles, both.tiles);
    EXPECT_EQ(alone.seen, both.seen);
    EXPECT_TRUE(std::ranges::all_of(alone.texels, [](float z) { return z == 0.125F; }));
    EXPECT_FALSE(std::ranges::all_of(both.texels, [](float z) { return z == 0.125F; }));
}

/// Where a tile was blank and still is nothing is written, and everywhere else all is: what stood
/// there before is planted.
TEST_P(DepthStage, OnlyWhatWasBlankAndStaysSoIsLeftAlone) {
    constexpr float planted = 0.125F;
    constexpr glm::ivec2 size{70, 64}; // tiles of 16 texels, the last in a row of 6
    constexpr int columns = 5;
    const auto count = static_cast<std::size_t>(size.x * size.y);
    const auto sheet = [&](glm::vec2 low, glm::vec2 high) {
        const auto corner = [&](float x, float y) {
            return glm::vec3{glm::vec2{x, y} / glm::vec2{size} * 2.0F - 1.0F, 0};
        };
        return DepthModel{device(),
                          {corner(low.x, low.y), corner(high.x, low.y), corner(high.x, high.y),
                           corner(low.x, high.y)},
                          {{0, 1, 2}, {0, 2, 3}},
                          64};
    };
    const DepthWanted all{glm::mat4{1}, size, {{0, 0}, size}, true};
    const std::vector<float> before(count, planted);
    const auto depth = to_device(device(), before);
    const auto numbers = to_device(device(), std::vector(count, 7U));
    const auto blank = to_device(device(), std::vector<std::uint8_t>(20, 0));
    const auto draw = [&](DepthModel model) {
        model.draw_into(stages(), all, *depth, *numbers, *blank);
    };
    const auto expect_tile = [&](int x, int y, bool is_blank, float texel, bool has_number) {
        SCOPED_TRACE(std::to_string(x) + ", " + std::to_string(y));
        const auto tile = static_cast<std::size_t>(y * columns + x);
        const auto at = static_cast<std::size_t>(16 * y * size.x + 16 * x);
        EXPECT_EQ(read_back<std::uint8_t>(device(), *blank, 20)[tile], is_blank ? 1 : 0);
        EXPECT_FLOAT_EQ(read_back<float>(device(), *depth, count)[at], texel);
        EXPECT_EQ(read_back<std::uint32_t>(device(), *numbers, count)[at] < 2U, has_number);
    };
    // Nothing is known: all is written.
    draw(sheet({0, 0}, {32, 32}));
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
        expect_tile(x, y, false, 0.5F, true);
    for (const auto& [x, y] : {std::pair{2, 0}, {3, 1}, {4, 0}, {4, 3}, {0, 2}})
        expect_tile(x, y, true, 1.0F, false);
    // Blank tiles hold something else: it stays, but where the next frame draws.
    device().upload(*depth, std::as_bytes(std::span{before}));
    draw(sheet({16, 0}, {48, 32}));
    for (const auto& [x, y] : {std::pair{1, 0}, {2, 0}, {1, 1}, {2, 1}})
        expect_tile(x, y, false, 0.5F, true);
    for (const auto& [x, y] : {std::pair{0, 0}, {0, 1}}) expect_tile(x, y, true, 1.0F, false);
    for (const auto& [x, y] : {std::pair{3, 1}, {4, 0}, {4, 3}, {0, 2}})
        expect_tile(x, y, true, planted, false);
}

/// What a form draws of a model.
struct Scene {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    glm::mat4 clip_from_world{1};
};

Scene strewn_scene(int count, glm::ivec2 size) {
    Scene scene;
    for (const glm::vec3& corner : strewn(count, size)) {
        scene.vertices.emplace_back(glm::vec2{corner} / glm::vec2{size} * 2.0F - 1.0F,
                                    corner.z * 2 - 1);
        const auto last = static_cast<std::uint32_t>(scene.vertices.size());
        if (last % 3 == 0) scene.triangles.emplace_back(last - 3, last - 2, last - 1);
    }
    return scene;
}

/// Sheets one upon the other, of which each has two triangles: who draws first shows everywhere.
Scene equal_sheets() {
    Scene scene;
    for (std::uint32_t i = 0; i < 150; ++i) {
        const float left = -0.9F + 0.1F * static_cast<float>(i % 7);
        for (const glm::vec2 corner :
             {glm::vec2{0, 0}, glm::vec2{1, 0}, glm::vec2{1, 1.2F}, glm::vec2{0, 1.2F}})
            scene.vertices.emplace_back(corner + left, i % 5 == 0 ? -0.25F : 0.25F);
        scene.triangles.emplace_back(4 * i, 4 * i + 1, 4 * i + 2);
        scene.triangles.emplace_back(4 * i, 4 * i + 2, 4 * i + 3);
    }
    return scene;
}

/// Walls and a floor from behind the eye to beyond the far plane, cut by many triangles.
Scene corridor() {
    const Floor floor;
    Scene scene{floor.vertices, floor.triangles, floor.clip_from_world};
    for (std::uint32_t i = 0; i < 60; ++i) {
        const float z = 4 - 2 * static_cast<float>(i), x = i % 2 == 0 ? 3.0F : -3.0F;
        const auto first = static_cast<std::uint32_t>(scene.vertices.size());
        scene.vertices.insert(scene.vertices.end(),
                              {{x, -1, z}, {x, -1, z - 3}, {0.2F * x, 2, z - 1}});
        scene.triangles.emplace_back(first, first + 1, first + 2);
    }
    return scene;
}

DrawnDepth draw_scene(DeviceStages& on, const Scene& scene, const DepthWanted& wanted) {
    return DepthModel{*on.device, scene.vertices, scene.triangles, 64}.draw(on.stages, wanted);
}

TEST_P(DepthStage, TilesAndTrianglesByThemselvesGiveTheSameBits) {
    if (GetParam().slow) GTEST_SKIP() << "one form is enough";
    DeviceStages own{GetParam().make()}, other{in_other_form(GetParam())};
    const glm::ivec2 size{610, 270};
    for (const Scene& scene : {strewn_scene(1500, size), equal_sheets(), corridor()}) {
        for (const TexelRectangle& part :
             {TexelRectangle{{0, 0}, size}, TexelRectangle{{37, 101}, {593, 270}}}) {
            const DepthWanted wanted{scene.clip_from_world, size, part, true};
            const DrawnDepth a = draw_scene(own, scene, wanted);
            const DrawnDepth b = draw_scene(other, scene, wanted);
            EXPECT_TRUE(equal(a.texels, b.texels));
            EXPECT_TRUE(equal(a.tiles, b.tiles));
            EXPECT_EQ(a.numbers, b.numbers);
            EXPECT_GT(std::ranges::count_if(a.texels, [](float z) { return z < 1; }), 10'000);
        }
    }
}

} // namespace
} // namespace lineatlas::test
