// The furniture of the office.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "office_parts.hpp"

namespace lineatlas::scenes {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

void add_keyboard(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at) {
    const MeshBuilder::OwnObject own{b};
    b.box(at, m.plastic, {-0.225F, gap, -0.075F}, {0.225F, 0.016F, 0.075F});
    const int keys[] = {11, 10, 10, 9};
    for (int row = 0; row < 4; ++row) {
        const float pitch = 0.43F / static_cast<float>(keys[row]);
        for (int i = 0; i < keys[row]; ++i) {
            const float x = -0.215F + pitch * static_cast<float>(i);
            const float z = -0.066F + 0.027F * static_cast<float>(row);
            b.box(at, m.keys, {x + 0.002F, 0.018F, z}, {x + pitch - 0.002F, 0.026F, z + 0.022F},
                  open_below);
        }
    }
    const float bottom[] = {-0.215F, -0.15F, -0.09F, 0.09F, 0.15F, 0.215F};
    for (int i = 0; i < 5; ++i)
        b.box(at, m.keys, {bottom[i] + 0.002F, 0.018F, 0.042F},
              {bottom[i + 1] - 0.002F, 0.026F, 0.066F}, open_below);
}

void add_monitor(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at) {
    const MeshBuilder::OwnObject own{b};
    b.box(at, m.plastic, {-0.13F, gap, -0.09F}, {0.13F, 0.018F, 0.09F});
    b.box(at, m.plastic, {-0.025F, 0.022F, -0.03F}, {0.025F, 0.30F, -0.012F});
    const glm::mat4 head = at * move({0, 0.36F, 0.012F}) * turn(-0.08F, {1, 0, 0});
    // One welded solid: the bezel, and the screen set back in it as another material.
    const glm::vec2 o{0.29F, 0.175F};
    const glm::vec2 i{0.28F, 0.163F};
    auto ring = [&](glm::vec2 h, float z) {
        const Path p{{-h.x, -h.y, z}, {h.x, -h.y, z}, {h.x, h.y, z}, {-h.x, h.y, z}};
        return b.ring(head, p);
    };
    const auto back = ring(o, -0.022F);
    const auto front = ring(o, 0.012F);
    const auto lip = ring(i, 0.012F);
    const auto screen = ring(i, 0.006F);
    b.quad(m.plastic, back[3], back[2], back[1], back[0]);
    b.loft(m.plastic, back, front, true);
    b.loft(m.plastic, front, lip, true);
    b.loft(m.plastic, lip, screen, true);
    b.quad(m.keys, screen[0], screen[1], screen[2], screen[3]);
}

void add_lamp(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at) {
    const MeshBuilder::OwnObject own{b};
    const glm::vec2 base[] = {{0.085F, gap}, {0.085F, 0.016F}, {0.02F, 0.03F}, {0, 0.031F}};
    b.lathe(at, m.metal, base, 10, true);
    const glm::vec3 elbow{0.10F, 0.34F, 0};
    const glm::vec3 head{-0.12F, 0.50F, 0.06F};
    auto arm = [&](glm::vec3 from, glm::vec3 to) {
        b.box(at * along(from, to), m.metal, {-0.008F, 0, -0.008F},
              {0.008F, glm::distance(from, to), 0.008F});
    };
    arm({0, 0.034F, 0}, elbow);
    arm(elbow, head);
    const glm::vec2 shade[] = {{0.085F, -0.09F}, {0.06F, -0.03F}, {0.025F, 0.0F}, {0, 0.01F}};
    b.lathe(at * move(head), m.metal, shade, 12, true);
}

void add_books(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at, float length,
               float height, std::uint32_t key) {
    float x = 0.006F;
    for (std::uint32_t i = 0; x < length - 0.07F; ++i) {
        const float thick = 0.032F + 0.044F * hash01(key, i, 1);
        if (hash01(key, i, 4) < 0.06F) { // a gap on the shelf
            x += 2.5F * thick;
            continue;
        }
        const float tall = height * (0.66F + 0.28F * hash01(key, i, 2));
        const float deep = 0.15F + 0.06F * hash01(key, i, 3);
        const Group g = hash01(key, i, 5) < 0.4F   ? m.paper
                        : hash01(key, i, 6) < 0.5F ? m.fabric
                                                   : m.wood;
        b.box(at, g, {x, 0.002F, -0.5F * deep + 0.045F}, {x + thick, tall, 0.5F * deep + 0.045F},
              all_faces & ~minus_z);
        x += thick + 0.003F;
    }
}

/// A cushion with rounded edges: a closed surface around the middle plane y = 0 of its transform.
void add_cushion(MeshBuilder& b, Group g, const glm::mat4& at, float width, float depth,
                 float thick, float curve, int n) {
    auto bend = [=](float x, float z) {
        return curve * (4 * x * x / (width * width) - 0.3F) * width + 0.25F * curve * z;
    };
    for (const float side : {1.0F, -1.0F})
        b.panel(at, g, n, n, [=](float u, float v) {
            const float x = width * (u - 0.5F);
            const float z = -side * depth * (v - 0.5F);
            const float s = 2 * u - 1;
            const float t = 2 * v - 1;
            const float body = std::sqrt(std::max(0.0F, (1 - s * s * s * s) * (1 - t * t * t * t)));
            return glm::vec3(x, bend(x, z) + side * (0.006F + 0.5F * thick * body), z);
        });
}

} // namespace

void add_chair(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at) {
    const MeshBuilder::OwnObject own{b};
    for (int i = 0; i < 5; ++i) {
        const glm::mat4 leg = at * turn(2 * pi * static_cast<float>(i) / 5);
        b.prism(leg * turn(-0.5F * pi, {1, 0, 0}), m.plastic,
                {{0.04F, -0.025F}, {0.31F, -0.014F}, {0.31F, 0.014F}, {0.04F, 0.025F}}, 0.065F,
                0.095F);
        b.box(leg * move({0.29F, 0, 0}), m.plastic, {-0.026F, gap, -0.02F},
              {0.026F, 0.058F, 0.02F});
    }
    const glm::vec2 column[] = {
        {0.032F, 0.07F}, {0.032F, 0.26F}, {0.018F, 0.262F}, {0.018F, 0.40F}};
    b.lathe(at, m.metal, column, 10, true);
    b.box(at, m.plastic, {-0.13F, 0.385F, -0.11F}, {0.13F, 0.41F, 0.16F});
    add_cushion(b, m.fabric, at * move({0, 0.46F, 0}), 0.49F, 0.47F, 0.075F, 0.05F, 5);
    add_cushion(b, m.fabric, at * move({0, 0.78F, 0.27F}) * turn(-0.5F * pi + 0.16F, {1, 0, 0}),
                0.46F, 0.50F, 0.055F, -0.12F, 5);
    b.box(at * move({0, 0.41F, 0.28F}) * turn(0.10F, {1, 0, 0}), m.plastic, {-0.03F, 0, 0.01F},
          {0.03F, 0.30F, 0.03F});
    for (const float side : {-0.28F, 0.28F}) {
        b.box(at, m.plastic, {side - 0.03F, 0.64F, -0.12F}, {side + 0.03F, 0.67F, 0.14F});
        b.box(at, m.plastic, {side - 0.012F, 0.40F, 0.0F}, {side + 0.012F, 0.636F, 0.05F});
    }
}

void add_desk(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at, std::uint32_t key) {
    const MeshBuilder::OwnObject own{b};
    b.box(at, m.wood, {-0.79F, 0.715F, -0.39F}, {0.79F, 0.74F, 0.39F});
    for (const float x : {-0.74F, 0.74F}) {
        for (const float z : {-0.34F, 0.34F})
            b.box(at, m.metal, {x - 0.025F, gap, z - 0.025F}, {x + 0.025F, 0.70F, z + 0.025F});
        b.box(at, m.metal, {x - 0.02F, 0.66F, -0.311F}, {x + 0.02F, 0.70F, 0.311F});
    }
    b.box(at, m.metal, {-0.711F, 0.40F, -0.33F}, {0.711F, 0.70F, -0.315F}); // modesty panel
    const glm::mat4 pedestal = at * move({hash01(key, 1) < 0.5F ? -0.46F : 0.46F, 0, 0.05F});
    b.box(pedestal, m.metal, {-0.21F, 0.03F, -0.27F}, {0.21F, 0.60F, 0.26F});
    for (int i = 0; i < 3; ++i) {
        const float y = 0.05F + 0.18F * static_cast<float>(i);
        b.box(pedestal, m.wood, {-0.20F, y, 0.264F}, {0.20F, y + 0.172F, 0.28F});
        b.box(pedestal, m.metal, {-0.06F, y + 0.12F, 0.284F}, {0.06F, y + 0.132F, 0.30F});
    }
    const glm::mat4 top = at * move({0, 0.74F, 0});
    const float twist = 0.25F * (hash01(key, 2) - 0.5F);
    add_monitor(b, m, top * move({-0.05F, 0, -0.20F}) * turn(twist));
    if (hash01(key, 3) < 0.35F) add_monitor(b, m, top * move({0.56F, 0, -0.17F}) * turn(-0.35F));
    add_keyboard(b, m, top * move({-0.05F, 0, 0.14F}) * turn(0.4F * twist));
    const glm::vec2 mouse[] = {{0.034F, gap}, {0.036F, 0.018F}, {0.022F, 0.034F}, {0, 0.038F}};
    b.lathe(top * move({0.28F, 0, 0.15F}), m.plastic, mouse, 10, true);
    if (hash01(key, 4) < 0.5F) add_lamp(b, m, top * move({-0.64F, 0, -0.22F}));
    if (hash01(key, 5) < 0.6F) {
        const glm::vec2 mug[] = {{0, gap},        {0.038F, gap},    {0.042F, 0.09F},
                                 {0.036F, 0.09F}, {0.032F, 0.012F}, {0, 0.012F}};
        b.lathe(top * move({0.42F, 0, 0.02F}), m.clay, mug, 12, true);
    }
    for (int i = 0; i < 3; ++i) // papers
        b.box(top * move({-0.52F, 0.003F * static_cast<float>(i), 0.12F}) *
                  turn(0.5F * (hash01(key, 6, static_cast<std::uint32_t>(i)) - 0.5F)),
              m.paper, {-0.105F, gap, -0.148F}, {0.105F, gap + 0.0015F, 0.148F}, open_below);
    if (hash01(key, 7) < 0.4F) add_books(b, m, top * move({0.20F, 0, -0.26F}), 0.30F, 0.26F, key);
}

void add_shelf(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at, std::uint32_t key) {
    const MeshBuilder::OwnObject own{b};
    for (const float x : {-0.5F, 0.48F})
        b.box(at, m.wood, {x, gap, -0.15F}, {x + 0.02F, 2.0F, 0.15F});
    b.box(at, m.wood, {-0.478F, 0.05F, -0.15F}, {0.478F, 1.99F, -0.14F});
    for (std::uint32_t i = 0; i < 6; ++i) {
        const float y = 0.05F + 0.385F * static_cast<float>(i);
        b.box(at, m.wood, {-0.477F, y, -0.07F}, {0.477F, y + 0.02F, 0.145F});
        if (i < 5) add_books(b, m, at * move({-0.475F, y + 0.02F, 0}), 0.95F, 0.35F, key * 8 + i);
    }
}

void add_plant(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at, std::uint32_t key) {
    const MeshBuilder::OwnObject own{b};
    const glm::vec2 pot[] = {{0, gap},       {0.15F, gap},   {0.20F, 0.36F}, {0.22F, 0.36F},
                             {0.22F, 0.40F}, {0.18F, 0.40F}, {0.17F, 0.35F}, {0, 0.35F}};
    b.lathe(at, m.clay, pot, 16, true);
    for (std::uint32_t i = 0; i < 24; ++i) {
        const float angle = 2.4F * static_cast<float>(i) + hash01(key, i);
        const float rise = 0.30F + 0.95F * hash01(key, i, 1);
        const float reach = 0.22F + 0.34F * hash01(key, i, 2);
        const float width = 0.05F + 0.05F * hash01(key, i, 3);
        b.panel(at * turn(angle), m.leaf, 2, 5, [=](float u, float v) {
            const float across = 2 * u - 1;
            const float leaf =
                width * (0.12F + std::sin(pi * std::pow(v, 1.4F))) * (1 - 0.75F * v * v * v);
            return glm::vec3(reach * v * v + 0.03F,
                             0.35F + rise * std::sin(1.9F * v) + 0.35F * leaf * std::abs(across),
                             -across * leaf);
        });
    }
}

void add_meeting_table(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at,
                       float length) {
    const MeshBuilder::OwnObject own{b};
    const float x = 0.5F * length;
    b.prism(at * lay_flat(), m.wood, rounded_rectangle({-x, -0.6F}, {x, 0.6F}, 0.25F, 6), 0.71F,
            0.745F);
    for (const float side : {-0.6F, 0.6F}) {
        const glm::vec2 foot[] = {{0, gap},       {0.32F, gap},   {0.30F, 0.03F},
                                  {0.06F, 0.06F}, {0.05F, 0.65F}, {0.2F, 0.70F}};
        b.lathe(at * move({side * x, 0, 0}), m.metal, foot, 16, true);
    }
    const int chairs = static_cast<int>(length / 0.8F);
    for (int i = 0; i < chairs; ++i) {
        const float s = -x + 0.8F * (static_cast<float>(i) + 0.5F) +
                        0.5F * (length - 0.8F * static_cast<float>(chairs));
        add_chair(b, m, at * move({s, 0, 0.78F}));
        add_chair(b, m, at * move({s, 0, -0.78F}) * turn(pi));
    }
}

void add_sofa(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at) {
    const MeshBuilder::OwnObject own{b};
    b.box(at, m.fabric, {-0.95F, 0.12F, -0.40F}, {0.95F, 0.30F, 0.40F});
    b.box(at, m.fabric, {-0.95F, 0.304F, 0.22F}, {0.95F, 0.80F, 0.40F});
    for (const float x : {-0.95F, 0.79F})
        b.box(at, m.fabric, {x, 0.304F, -0.40F}, {x + 0.16F, 0.58F, 0.216F});
    for (const float x : {-0.395F, 0.395F})
        add_cushion(b, m.fabric, at * move({x, 0.40F, -0.09F}), 0.76F, 0.58F, 0.14F, 0.0F, 8);
    for (const float x : {-0.9F, 0.9F})
        for (const float z : {-0.34F, 0.34F})
            b.box(at, m.wood, {x - 0.03F, gap, z - 0.03F}, {x + 0.03F, 0.116F, z + 0.03F});
}

} // namespace lineatlas::scenes
