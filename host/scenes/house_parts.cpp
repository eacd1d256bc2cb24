// The parts of the house: terraces, walls and windows, furniture, rock and trees.
#include "house_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

namespace lineatlas::scenes::house {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
const glm::mat4 here(1);

} // namespace

void add_terrace(MeshBuilder& b, const Materials& m, glm::vec2 lo, glm::vec2 hi, float floor,
                 float parapet) {
    auto ring = [&](float inset, float y) {
        Path points;
        for (const glm::vec2& p : rounded_rectangle(lo + inset, hi - inset, 0.12F, 3))
            points.emplace_back(p.x, y, -p.y);
        return b.ring(here, points);
    };
    const float top = floor + parapet;
    // Thickness of the parapet 0.26: out, over the rim, and down to the floor.
    const auto underside = ring(0, floor - 0.38F);
    const auto outside = ring(0, top - 0.09F);
    const auto shoulder = ring(0.03F, top - 0.02F);
    const auto crest = ring(0.10F, top);
    const auto inner_crest = ring(0.16F, top);
    const auto inside = ring(0.25F, top - 0.09F);
    const auto foot = ring(0.26F, floor);
    b.loft(m.concrete, underside, outside, true);
    b.loft(m.rim, outside, shoulder, true);
    b.loft(m.rim, shoulder, crest, true);
    b.loft(m.rim, crest, inner_crest, true);
    b.loft(m.rim, inner_crest, inside, true);
    b.loft(m.concrete, inside, foot, true);
    Outline paving;
    for (const std::uint32_t v : foot) paving.emplace_back(b.position(v).x, -b.position(v).z);
    for (const glm::uvec3& t : triangulate(paving, {}))
        b.triangle(m.stone, foot[t.x], foot[t.y], foot[t.z]);
    for (const glm::uvec3& t : triangulate(rounded_rectangle(lo, hi, 0.12F, 3), {}))
        b.triangle(m.concrete, underside[t.x], underside[t.z], underside[t.y]);
}

void add_stone_wall(MeshBuilder& b, const Materials& m, const glm::mat4& at, float length,
                    float height, float thickness, std::uint32_t key) {
    float y = gap;
    for (std::uint32_t course = 0; y < height - 0.12F; ++course) {
        float rise = 0.26F + 0.20F * hash01(key, course);
        if (y + rise > height - 0.14F) rise = height - gap - y;
        float x = 0;
        for (std::uint32_t i = 0; x < length - 0.01F; ++i) {
            float run = 0.85F + 1.45F * hash01(key, course, i + 1);
            if (x + run > length - 0.4F) run = length - x;
            const float out = 0.06F * hash01(key + 7, course, i);
            const float back = 0.06F * hash01(key + 9, course, i);
            b.box(at, m.stone, {x + 0.003F, y, -0.5F * thickness - back},
                  {x + run - 0.003F, y + rise - 0.006F, 0.5F * thickness + out});
            x += run;
        }
        y += rise;
    }
}

void add_windows(MeshBuilder& b, const Materials& m, const glm::mat4& at, float length,
                 float height, int bays) {
    const float bay = length / static_cast<float>(bays);
    for (const float y : {gap, height - 0.08F - gap})
        b.box(at, m.frame, {0, y, -0.06F}, {length, y + 0.08F, 0.06F});
    for (int i = 0; i <= bays; ++i) {
        const float x =
            glm::mix(0.03F, length - 0.03F, static_cast<float>(i) / static_cast<float>(bays));
        b.box(at, m.frame, {x - 0.03F, 0.088F, -0.05F}, {x + 0.03F, height - 0.092F, 0.05F});
    }
    for (int i = 0; i < bays; ++i) {
        const bool open = i % 5 == 3;
        const glm::mat4 cell = at * move({bay * static_cast<float>(i), 0, 0});
        for (int row = 1; row < 4; row += 2) {
            const float y = height * static_cast<float>(row) / 4;
            b.box(cell, m.frame, {0.068F, y - 0.02F, -0.025F}, {bay - 0.068F, y + 0.02F, 0.025F});
        }
        if (!open) continue;
        const float y0 = 0.25F * height + 0.03F;
        const float y1 = 0.75F * height - 0.03F;
        const glm::mat4 leaf = cell * move({0.07F, 0, 0.06F}) * turn(-0.9F);
        const float w = bay - 0.15F;
        for (const float x : {0.0F, w - 0.04F})
            b.box(leaf, m.frame, {x, y0, 0}, {x + 0.04F, y1, 0.03F});
        for (const float y : {y0, y1 - 0.04F})
            b.box(leaf, m.frame, {0.044F, y, 0}, {w - 0.044F, y + 0.04F, 0.03F});
    }
}

void add_rail(MeshBuilder& b, const Materials& m, glm::vec3 from, glm::vec3 to, int posts) {
    for (int i = 0; i <= posts; ++i) {
        const glm::vec3 p = glm::mix(from, to, static_cast<float>(i) / static_cast<float>(posts));
        b.rod(m.metal, p + glm::vec3(0, gap, 0), p + glm::vec3(0, 0.90F, 0), 0.02F, 6);
    }
    for (const float y : {0.35F, 0.63F, 0.935F})
        b.rod(m.metal, from + glm::vec3(0, y, 0.045F), to + glm::vec3(0, y, 0.045F), 0.018F, 6);
}

void add_steps(MeshBuilder& b, Group g, glm::vec3 foot, glm::vec3 run, float rise, int count,
               glm::vec3 half) {
    for (int i = 0; i < count; ++i)
        b.box(move(foot + static_cast<float>(i) * (run + glm::vec3(0, rise, 0))), g, -half, half);
}

void add_chair(MeshBuilder& b, const Materials& m, const glm::mat4& at) {
    b.box(at, m.fabric, {-0.24F, 0.42F, -0.24F}, {0.24F, 0.48F, 0.24F});
    b.box(at, m.wood, {-0.24F, 0.484F, 0.20F}, {0.24F, 0.95F, 0.24F});
    for (const float x : {-0.2F, 0.2F})
        for (const float z : {-0.2F, 0.2F})
            b.box(at, m.wood, {x - 0.025F, gap, z - 0.025F}, {x + 0.025F, 0.416F, z + 0.025F});
}

void add_table(MeshBuilder& b, const Materials& m, const glm::mat4& at, float length, int chairs) {
    b.box(at, m.wood, {-0.5F * length, 0.70F, -0.45F}, {0.5F * length, 0.75F, 0.45F});
    for (const float x : {-0.42F, 0.42F})
        b.box(at * move({x * length, 0, 0}), m.wood, {-0.04F, gap, -0.36F}, {0.04F, 0.696F, 0.36F});
    for (int i = 0; i < chairs; ++i) {
        const float x =
            length * ((static_cast<float>(i) + 0.5F) / static_cast<float>(chairs) - 0.5F);
        add_chair(b, m, at * move({x, 0, 0.62F}));
        add_chair(b, m, at * move({x, 0, -0.62F}) * turn(pi));
    }
}

void add_bed(MeshBuilder& b, const Materials& m, const glm::mat4& at) {
    b.box(at, m.wood, {-0.85F, 0.10F, -1.05F}, {0.85F, 0.30F, 1.05F});
    b.box(at, m.wood, {-0.95F, gap, -1.13F}, {0.95F, 1.0F, -1.06F});
    b.panel(at * move({0, 0.305F, 0}), m.fabric, 6, 8, [](float u, float v) {
        const float edge = std::pow(std::max(0.0F, std::sin(pi * u) * std::sin(pi * v)), 0.25F);
        return glm::vec3(1.64F * (u - 0.5F), (0.24F + (v > 0.8F ? 0.1F : 0.0F)) * edge,
                         -2.04F * (v - 0.5F));
    });
}

void add_shelves(MeshBuilder& b, const Materials& m, const glm::mat4& at, float length,
                 std::uint32_t key) {
    for (std::uint32_t row = 0; row < 4; ++row) {
        const float y = 0.3F + 0.45F * static_cast<float>(row);
        b.box(at, m.wood, {0, y, -0.15F}, {length, y + 0.03F, 0.15F});
        float x = 0.03F;
        for (std::uint32_t i = 0; x < length - 0.12F; ++i) {
            const float thick = 0.05F + 0.07F * hash01(key, row, i);
            if (hash01(key + 1, row, i) < 0.5F)
                b.box(at, i % 3 == 0 ? m.wood : m.fabric, {x, y + 0.033F, -0.10F},
                      {x + thick, y + 0.20F + 0.14F * hash01(key + 2, row, i), 0.11F});
            x += thick + gap;
        }
    }
}

void add_terrain(MeshBuilder& b, const Materials& m) {
    for (int layer = 0; layer < 8; ++layer) {
        const auto key = static_cast<std::uint32_t>(layer);
        Outline outline;
        constexpr int points = 58;
        const float s = static_cast<float>(layer);
        for (int i = 0; i < points; ++i) {
            const float angle = 2 * pi * static_cast<float>(i) / points;
            const float front =
                std::max(0.0F, -std::sin(angle)); // towards the stream the ledges draw back
            const float rough = 0.91F + 0.14F * hash01(31, key, static_cast<std::uint32_t>(i));
            const float radius = rough * (13.6F - 0.35F * s - front * 0.95F * s);
            outline.emplace_back(1.15F * radius * std::cos(angle),
                                 radius * std::sin(angle) + 0.25F * s);
        }
        const float y = -4.6F + 0.62F * s;
        b.prism(lay_flat(), m.rock, outline, y + gap, y + 0.615F);
    }
}

void add_tree(MeshBuilder& b, const Materials& m, glm::vec3 foot, float height, std::uint32_t key) {
    const glm::vec2 trunk[] = {
        {0.30F, gap}, {0.22F, 0.1F * height}, {0.16F, 0.5F * height}, {0.04F, height}};
    b.lathe(move(foot), m.bark, trunk, 10, true);
    for (std::uint32_t i = 0; i < 8; ++i) {
        const float up = height * (0.32F + 0.08F * static_cast<float>(i));
        const float angle = 2.4F * static_cast<float>(i) + hash01(key, i);
        const float reach = (0.34F - 0.030F * static_cast<float>(i)) * height * 0.75F;
        Path branch;
        for (int k = 0; k < 3; ++k) {
            const float s = static_cast<float>(k) / 2;
            branch.push_back(foot + glm::vec3(std::cos(angle + 0.3F * s) * (0.1F + reach * s),
                                              up + 0.55F * reach * s * (1.4F - 0.5F * s),
                                              std::sin(angle + 0.3F * s) * (0.1F + reach * s)));
        }
        b.tube(here, m.bark, branch, 0.045F, 3);
    }
}

} // namespace lineatlas::scenes::house
