#include "lineatlas/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "compare.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

bool finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

class SceneTest : public testing::TestWithParam<std::string> {};

TEST_P(SceneTest, HasTheTriangleCountOfTable1) {
    const std::string name = GetParam();
    const double expected = name == "clevis"  ? 1000
                            : name == "house" ? 15000
                            : name == "ship"  ? 300000
                                              : 330000;
    const Scene scene = make_scene(name);
    EXPECT_EQ(scene.name, name);
    EXPECT_NEAR(static_cast<double>(scene.mesh.triangles.size()), expected, 0.05 * expected);
}

TEST_P(SceneTest, MeshIsSound) {
    const Mesh mesh = make_scene(GetParam()).mesh;
    for (const glm::vec3& p : mesh.positions) ASSERT_TRUE(finite(p));
    ASSERT_FALSE(mesh.groups.empty());
    ASSERT_EQ(mesh.triangle_group.size(), mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
        const glm::vec3 a = mesh.positions[t.x];
        ASSERT_GT(glm::length(glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a)), 0.0F)
            << "triangle " << i << " has no area";
        ASSERT_LT(mesh.triangle_group[i], mesh.groups.size());
    }
    for (const MeshGroup& group : mesh.groups) {
        EXPECT_FALSE(group.object.empty());
        EXPECT_FALSE(group.material.empty());
        ASSERT_TRUE(group.color);
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE((*group.color)[c], 0.0F);
            EXPECT_LE((*group.color)[c], 1.0F);
        }
    }
}

TEST_P(SceneTest, IsTheSameEveryTime) {
    const Mesh first = make_scene(GetParam()).mesh;
    const Mesh second = make_scene(GetParam()).mesh;
    EXPECT_TRUE(test::same_bits(first.positions, second.positions));
    EXPECT_EQ(first.triangles, second.triangles);
    EXPECT_EQ(first.triangle_group, second.triangle_group);
}

TEST_P(SceneTest, CameraMovesSmoothly) {
    const Scene scene = make_scene(GetParam());
    constexpr int steps = 2000;
    const View start = scene.view(0);
    EXPECT_GT(start.near, 0.0F);
    EXPECT_GT(start.far, start.near);
    View before = start;
    float length = 0;
    float longest = 0;
    for (int i = 1; i <= steps; ++i) {
        const View view = scene.view(static_cast<float>(i) / steps);
        ASSERT_TRUE(finite(view.eye) && finite(view.target));
        ASSERT_GT(glm::distance(view.eye, view.target), view.near);
        ASSERT_EQ(view.near, start.near);
        ASSERT_EQ(view.far, start.far);
        ASSERT_EQ(view.fov_y, start.fov_y);
        const float step = glm::distance(view.eye, before.eye);
        length += step;
        longest = std::max(longest, step);
        before = view;
    }
    EXPECT_GT(length, 0.0F);
    EXPECT_LT(longest, 10 * length / steps) << "the camera jumps";
}

INSTANTIATE_TEST_SUITE_P(AllScenes, SceneTest, testing::Values("clevis", "house", "ship", "office"),
                         [](const auto& info) { return info.param; });

TEST(Scenes, OrbitsClose) {
    for (const char* name : {"clevis", "house"}) {
        const Scene scene = make_scene(name);
        EXPECT_EQ(scene.view(0).eye, scene.view(1).eye);
        EXPECT_EQ(scene.view(0).target, scene.view(1).target);
    }
}

TEST(Scenes, NamesAreInTheOrderOfTable1) {
    const auto names = scene_names();
    const std::vector<std::string_view> expected{"clevis", "house", "ship", "office"};
    EXPECT_EQ(std::vector<std::string_view>(names.begin(), names.end()), expected);
}

TEST(Scenes, UnknownNameIsAUsageErrorThatListsTheKnownOnes) {
    try {
        make_scene("teapot");
        FAIL() << "no exception";
    } catch (const UsageError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("teapot"), std::string::npos);
        for (const std::string_view name : scene_names())
            EXPECT_NE(message.find(name), std::string::npos) << message;
    }
}

} // namespace
} // namespace lineatlas
