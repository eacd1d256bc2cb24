#include "core/up_axis.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "test_meshes.hpp"

namespace lineatlas {
namespace {

const glm::vec3 y{0, 1, 0}, z{0, 0, 1};

void add_box(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.emplace_back((corner & 1) != 0 ? high.x : low.x,
                                    (corner & 2) != 0 ? high.y : low.y,
                                    (corner & 4) != 0 ? high.z : low.z);
    }
    for (const glm::uvec4 side : {glm::uvec4{0, 2, 3, 1},
                                  {4, 5, 7, 6},
                                  {0, 1, 5, 4},
                                  {2, 6, 7, 3},
                                  {0, 4, 6, 2},
                                  {1, 3, 7, 5}}) {
        mesh.triangles.push_back(glm::uvec3{side.x, side.y, side.z} + first);
        mesh.triangles.push_back(glm::uvec3{side.x, side.z, side.w} + first);
    }
}

/// A table with its top upwards, or turned so that z is where y was.
Mesh table(bool z_up) {
    Mesh mesh;
    add_box(mesh, {-1, 0.9F, -0.5F}, {1, 1, 0.5F});
    for (const float x : {-0.95F, 0.85F}) {
        for (const float depth : {-0.45F, 0.35F}) {
            add_box(mesh, {x, 0, depth}, {x + 0.1F, 0.9F, depth + 0.1F});
        }
    }
    if (z_up) {
        for (glm::vec3& p : mesh.positions) p = {p.x, -p.z, p.y};
    }
    return mesh;
}

TEST(GuessUp, ATableStandsOnItsLegsWhateverIsUsual) {
    for (const UsualUp usual : {UsualUp::y, UsualUp::z}) {
        EXPECT_EQ(guess_up(table(false), usual), y);
        EXPECT_EQ(guess_up(table(true), usual), z);
    }
}

/// The boxes from `low` to `high`, or the same laid over so that z is where y was.
Mesh boxes(const std::vector<std::pair<glm::vec3, glm::vec3>>& corners, bool z_up) {
    Mesh mesh;
    for (const auto& [low, high] : corners) add_box(mesh, low, high);
    if (z_up) {
        for (glm::vec3& p : mesh.positions) p = {p.x, -p.z, p.y};
    }
    return mesh;
}

/// The table of docs/input.md.
TEST(GuessUp, ShapesStandAsTheyAreMeantWhateverIsUsual) {
    const std::vector<std::vector<std::pair<glm::vec3, glm::vec3>>> shapes{
        {{{-1, 0, -1}, {1, 0.3F, 1}}, {{-0.3F, 0.3F, -0.3F}, {0.3F, 4, 0.3F}}},    // on a plinth
        {{{-1, 0, -1}, {1, 0.2F, 1}}, {{-0.3F, 0.2F, -0.3F}, {0.3F, 0.6F, 0.3F}}}, // a boss
        {{{-0.2F, 0, -0.2F}, {0.2F, 2, 0.2F}}, {{-0.4F, 2, -0.4F}, {0.4F, 2.4F, 0.4F}}}, // a bolt
        {{{-2, 0, -0.5F}, {-1.5F, 2, 0.5F}},                                             // an arch
         {{1.5F, 0, -0.5F}, {2, 2, 0.5F}},
         {{-2, 2, -0.5F}, {2, 2.5F, 0.5F}}}};
    for (const auto& shape : shapes) {
        for (const UsualUp usual : {UsualUp::y, UsualUp::z}) {
            EXPECT_EQ(guess_up(boxes(shape, false), usual), y);
            EXPECT_EQ(guess_up(boxes(shape, true), usual), z);
        }
    }
}

TEST(GuessUp, WhatStandsOnTwoSidesStandsAsIsUsual) {
    std::vector<std::pair<glm::vec3, glm::vec3>> stairs;
    for (int i = 0; i < 5; ++i) {
        const auto step = static_cast<float>(i);
        stairs.push_back({{0, 0.2F * step, 0.3F * step}, {1, 0.2F * (step + 1), 1.5F}});
    }
    const std::vector<std::pair<glm::vec3, glm::vec3>> bracket{{{-0.5F, 0, 0}, {0.5F, 0.1F, 1}},
                                                               {{-0.5F, 0.1F, 0}, {0.5F, 1, 0.1F}}};
    for (const auto& shape : {stairs, bracket}) {
        for (const bool z_up : {false, true}) {
            EXPECT_EQ(guess_up(boxes(shape, z_up), UsualUp::y), y);
            EXPECT_EQ(guess_up(boxes(shape, z_up), UsualUp::z), z);
        }
    }
}

TEST(GuessUp, WhatIsAlikeOnAllSidesStandsAsIsUsual) {
    Mesh cube;
    add_box(cube, {-1, -1, -1}, {1, 1, 1});
    EXPECT_EQ(guess_up(cube, UsualUp::y), y);
    EXPECT_EQ(guess_up(cube, UsualUp::z), z);
}

TEST(GuessUp, LittleDifferenceChangesNothing) {
    Mesh mesh;
    add_box(mesh, {-1, -1, -1}, {1, 1, 1});
    add_box(mesh, {-0.2F, -0.2F, 1}, {0.2F, 0.2F, 1.01F}); // a label on one side
    EXPECT_EQ(guess_up(mesh, UsualUp::y), y);
}

TEST(GuessUp, WithoutTrianglesWhatIsUsualStays) {
    Mesh mesh;
    EXPECT_EQ(guess_up(mesh, UsualUp::y), y);
    mesh.positions = {{0, 0, 0}, {1, 2, 3}};
    mesh.polylines = {{0, 1}};
    EXPECT_EQ(guess_up(mesh, UsualUp::z), z);
}

} // namespace
} // namespace lineatlas
