// A house over a waterfall: cantilevered terraces around a stone chimney, on ledges of rock.
#include <numbers>

#include "camera_path.hpp"
#include "house_parts.hpp"
#include "scene_list.hpp"

namespace lineatlas::scenes {

using namespace house;

namespace {

constexpr float pi = std::numbers::pi_v<float>;
const glm::mat4 here(1);

void add_storey_one(MeshBuilder& b, const Materials& m) {
    constexpr float floor = 1.2F;
    add_terrace(b, m, {-6.5F, -8.2F}, {8.0F, 4.6F}, floor, 0.95F);
    add_terrace(b, m, {8.3F, -4.0F}, {12.4F, 2.0F}, floor - 0.455F, 0.9F);
    const float up = floor;
    add_windows(b, m, move({-4.4F, up, 3.6F}), 10.4F, 2.62F, 13);
    add_windows(b, m, move({6.1F, up, 3.5F}) * turn(0.5F * pi), 3.6F, 2.62F, 5);
    add_windows(b, m, move({-4.5F, up, -0.6F}) * turn(-0.5F * pi), 4.1F, 2.62F, 5);
    add_stone_wall(b, m, move({-5.9F, up, -3.9F}), 13.2F, 2.62F, 0.5F, 1);
    add_stone_wall(b, m, move({6.8F, up, -2.2F}) * turn(0.5F * pi), 1.3F, 2.62F, 0.5F, 2);
    add_stone_wall(b, m, move({-5.4F, up, -3.5F}) * turn(-0.5F * pi), 2.7F, 2.62F, 0.5F, 3);
    add_table(b, m, move({1.2F, up, -1.6F}), 2.6F, 4);
    add_table(b, m, move({-2.6F, up, 2.0F}), 1.6F, 2);
    add_table(b, m, move({4.2F, up, 6.1F}), 1.8F, 2);
    add_shelves(b, m, move({-3.4F, up, -3.41F}), 3.6F, 21);
    b.box(move({1.6F, up, 2.6F}), m.fabric, {-1.6F, 0.12F, -0.4F},
          {1.6F, 0.42F, 0.4F}); // window seat
    for (int i = 0; i < 4; ++i)
        b.box(move({0.4F + 0.8F * static_cast<float>(i), up + 0.424F, 2.6F}), m.fabric,
              {-0.39F, 0, -0.38F}, {0.39F, 0.12F, 0.38F});
    // The hatch stair that hangs down to the stream, and its rods.
    for (int i = 0; i < 13; ++i) {
        const glm::vec3 p{-2.2F - 0.30F * static_cast<float>(i),
                          floor - 0.55F - 0.235F * static_cast<float>(i), 7.2F};
        b.box(move(p), m.concrete, {-0.17F, -0.05F, -0.6F}, {0.17F, 0.05F, 0.6F});
        if (i % 3 == 1)
            for (const float z : {-0.5F, 0.5F})
                b.rod(m.metal, p + glm::vec3(0, 0.054F, z), {p.x, floor - 0.384F, p.z + z}, 0.018F,
                      6);
    }
    // Bolsters that carry the terrace, and piers on the rock.
    for (int i = 0; i < 4; ++i) {
        const float x = -4.6F + 3.4F * static_cast<float>(i);
        const glm::mat4 at = move({x, floor - 0.384F, 0}) * turn(-0.5F * pi);
        b.prism(at, m.concrete,
                {{-3.5F, -0.455F}, {1.2F, -0.455F}, {5.0F, -0.35F}, {5.0F, 0}, {-3.5F, 0}}, -0.22F,
                0.22F);
    }
    for (int i = 0; i < 3; ++i)
        add_stone_wall(b, m, move({-4.34F + 3.4F * static_cast<float>(i), ground, 0.6F}), 2.88F,
                       0.45F, 0.7F, 4 + 20 * static_cast<std::uint32_t>(i));
}

void add_storey_two(MeshBuilder& b, const Materials& m) {
    constexpr float floor = 4.25F;
    add_terrace(b, m, {-9.2F, -2.6F}, {3.4F, 4.4F}, floor, 0.9F);
    b.box(here, m.concrete, {3.42F, floor - 0.30F, -4.3F},
          {7.4F, floor, 4.3F}); // roof of the living room
    for (int i = 0; i < 9; ++i) // trellis over the terrace beside it
        b.box(move({7.44F + 0.5F * static_cast<float>(i), floor - 0.26F, 0}), m.concrete,
              {0, 0, -3.4F}, {0.16F, 0.22F, 2.9F});
    for (const float z : {-3.68F, 2.92F}) // the beams that carry it, and their posts
        b.box(here, m.concrete, {7.42F, floor - 0.30F, z}, {11.9F, floor + 0.02F, z + 0.26F});
    b.box(move({11.6F, 0.745F, 3.05F}), m.stone, {-0.25F, gap, -0.25F},
          {0.25F, floor - 0.745F - 0.304F, 0.25F});
    b.box(move({11.6F, ground, -3.55F}), m.stone, {-0.25F, gap, -0.25F},
          {0.25F, floor - ground - 0.304F, 0.25F});
    add_windows(b, m, move({-5.0F, floor, 0.6F}), 7.4F, 2.31F, 9);
    add_windows(b, m, move({-5.1F, floor, -3.5F}) * turn(-0.5F * pi), 4.0F, 2.31F, 5);
    add_stone_wall(b, m, move({-5.0F, floor, -3.8F}), 8.0F, 2.31F, 0.5F, 5);
    add_stone_wall(b, m, move({2.8F, floor, 0.7F}) * turn(0.5F * pi), 4.1F, 2.31F, 0.5F, 6);
    b.box(here, m.wood, {-1.0F, floor + gap, -3.4F},
          {-0.9F, floor + 2.30F, -0.6F}); // between two bedrooms
    add_bed(b, m, move({-3.2F, floor, -2.2F}));
    add_bed(b, m, move({0.8F, floor, -2.2F}));
    add_shelves(b, m, move({-4.9F, floor, 0.1F}), 1.6F, 22);
    add_table(b, m, move({-7.2F, floor, 1.6F}) * turn(0.5F * pi), 1.6F, 2);
    add_steps(b, m.stone, {6.8F, floor + gap + 0.09F, -3.78F}, {-0.28F, 0, 0}, 0.19F, 12,
              {0.19F, 0.09F, 0.46F});
}

void add_storey_three(MeshBuilder& b, const Materials& m) {
    constexpr float floor = 6.95F;
    add_terrace(b, m, {-6.0F, -1.6F}, {3.4F, 4.2F}, floor, 0.75F);
    add_windows(b, m, move({-3.6F, floor, 0.0F}), 5.0F, 2.2F, 6);
    add_windows(b, m, move({-3.7F, floor, -3.3F}) * turn(-0.5F * pi), 3.2F, 2.2F, 4);
    add_stone_wall(b, m, move({-3.8F, floor, -3.6F}), 5.4F, 2.2F, 0.45F, 7);
    add_table(b, m, move({-1.6F, floor, -1.6F}), 1.6F, 2);
    b.prism(lay_flat(), m.concrete, rounded_rectangle({-5.0F, -1.1F}, {3.3F, 4.3F}, 0.3F, 4),
            floor + 2.21F, floor + 2.46F);
    b.prism(lay_flat(), m.concrete, rounded_rectangle({-3.8F, -0.4F}, {2.6F, 3.6F}, 0.3F, 4),
            floor + 2.464F, floor + 2.62F);
}

/// The chimney: a tower of stone through all storeys.
void add_chimney(MeshBuilder& b, const Materials& m) {
    // It stands beside the terraces; the roof of the living room parts it in two.
    for (int face = 0; face < 2; ++face) {
        const float x = face == 0 ? 3.46F : 3.48F;
        const float z = face == 0 ? -0.95F : -2.48F;
        const float thickness = face == 0 ? 1.35F : 1.45F;
        const auto key = 8 + 4 * static_cast<std::uint32_t>(face);
        add_stone_wall(b, m, move({x, 1.2F, z}), 2.6F, 2.746F, thickness, key);
        add_stone_wall(b, m, move({x, 4.25F, z}), 2.6F, 6.976F, thickness, key + 1);
    }
    b.box(here, m.concrete, {3.31F, 11.23F, -3.3F}, {6.21F, 11.42F, -0.15F});
    for (const float x : {4.01F, 5.41F}) {
        const glm::vec2 pot[] = {{0.28F, 11.424F}, {0.24F, 11.9F}, {0.28F, 11.95F}, {0.28F, 12.05F},
                                 {0.2F, 12.05F},   {0.18F, 11.5F}, {0, 11.5F}};
        b.lathe(move({x, 0, -1.7F}), m.stone, pot, 12, true);
    }
    // The stair tower, below and above the second terrace.
    const glm::mat4 tower = turn(0.5F * pi);
    add_stone_wall(b, m, move({-6.97F, ground, -0.4F}) * tower, 2.2F, 3.866F - ground, 0.7F, 11);
    add_stone_wall(b, m, move({-6.97F, 4.25F, -0.4F}) * tower, 2.2F, 2.75F, 0.7F, 16);
}

} // namespace

Scene make_house() {
    MeshBuilder b;
    const Materials m{b.group("terraces", "concrete", {0.94F, 0.88F, 0.77F}),
                      b.group("terraces", "rim", {0.96F, 0.92F, 0.83F}),
                      b.group("walls", "stone", {0.77F, 0.73F, 0.66F}),
                      b.group("terrain", "rock", {0.80F, 0.77F, 0.71F}),
                      b.group("windows", "painted_steel", {0.76F, 0.50F, 0.42F}),
                      b.group("furniture", "wood", {0.78F, 0.64F, 0.49F}),
                      b.group("furniture", "fabric", {0.88F, 0.74F, 0.58F}),
                      b.group("rails", "metal", {0.62F, 0.63F, 0.64F}),
                      b.group("trees", "bark", {0.66F, 0.60F, 0.53F})};
    add_terrain(b, m);
    add_storey_one(b, m);
    add_storey_two(b, m);
    add_storey_three(b, m);
    add_chimney(b, m);
    add_rail(b, m, {7.25F, 4.25F, 4.1F}, {7.25F, 4.25F, -4.1F}, 8);
    add_steps(b, m.rock, {-11.0F, ground + gap + 0.08F, -1.5F}, {0.34F, 0, 0}, 0.17F, 9,
              {0.2F, 0.08F, 0.8F});
    const glm::vec3 trees[] = {
        {-11, ground, -4.5F}, {-8, ground, -7.6F}, {9.5F, ground, -6.5F}, {4.5F, ground, -9.4F}};
    for (std::uint32_t i = 0; i < 4; ++i) add_tree(b, m, trees[i], 10 + 4 * hash01(51, i), i);

    Scene scene;
    scene.mesh = b.take();
    scene.view = orbit({0, 0.6F, 0}, 43, 0.26F, 1.05F, 10, 80);
    return scene;
}

} // namespace lineatlas::scenes
