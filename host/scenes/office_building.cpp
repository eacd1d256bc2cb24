// The shell of the office building: slabs, columns, facade, core and stairs; and how each storey is
// divided and furnished.
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

#include "office_parts.hpp"

namespace lineatlas::scenes {

using namespace office;

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float clear_height = storey_height - slab;

/// One side of the facade on one storey, along x from 0 to `length`, outside towards +z. Bay
/// `entrance` (if not negative) and its neighbour are left open.
void add_facade(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at, float length,
                int entrance) {
    const int bays = static_cast<int>(std::round(length / 1.2F));
    const float bay = length / static_cast<float>(bays);
    for (int i = 0; i <= bays; ++i) {
        if (i == entrance + 1 && entrance >= 0) continue;
        b.box(at * move({bay * static_cast<float>(i), 0, 0}), m.frame, {-0.03F, gap, -0.06F},
              {0.03F, clear_height - gap, 0.09F});
    }
    for (int i = 0; i < bays; ++i) {
        const glm::mat4 cell = at * move({bay * static_cast<float>(i), 0, 0});
        const bool door = entrance >= 0 && (i == entrance || i == entrance + 1);
        auto transom = [&](float y, float height, float deep) {
            b.box(cell, m.frame, {0.034F, y, -deep}, {bay - 0.034F, y + height, deep});
        };
        transom(clear_height - 0.07F, 0.06F, 0.04F);
        transom(2.45F, 0.05F, 0.035F);
        if (door) continue;
        transom(0.01F, 0.06F, 0.04F);
        transom(0.85F, 0.05F, 0.035F);
        b.box(cell, m.plaster, {0.05F, 0.08F, -0.01F}, {bay - 0.05F, 0.84F, 0.01F}); // spandrel
        // Opening lights in some bays, and fins that shade the glass.
        if ((i * 7 + static_cast<int>(length)) % 4 == 0) {
            for (const float x : {0.06F, bay - 0.10F})
                b.box(cell, m.frame, {x, 0.93F, -0.02F}, {x + 0.04F, 2.42F, 0.03F});
            for (const float y : {0.93F, 2.38F})
                b.box(cell, m.frame, {0.104F, y, -0.02F}, {bay - 0.104F, y + 0.04F, 0.03F});
        }
        b.box(cell, m.metal, {0.034F, 2.62F, 0.04F}, {bay - 0.034F, 2.64F, 0.42F});
    }
}

/// A wall along x from 0 to `length`, `height` high, with doorways at `doors` (their left edges).
void add_partition(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at, float length,
                   std::span<const float> doors, float height = clear_height) {
    constexpr float width = 0.95F;
    constexpr float head = 2.10F;
    Outline outline{{0, gap}};
    for (const float d : doors) {
        outline.insert(outline.end(), {{d, gap}, {d, head}, {d + width, head}, {d + width, gap}});
    }
    outline.insert(outline.end(), {{length, gap}, {length, height - gap}, {0, height - gap}});
    b.prism(at, m.plaster, outline, -0.06F, 0.06F);
    for (const float d : doors) {
        const glm::mat4 door = at * move({d, 0, 0});
        for (const float x : {0.004F, width - 0.054F})
            b.box(door, m.frame, {x, gap, -0.08F}, {x + 0.05F, head - gap, 0.08F});
        b.box(door, m.frame, {0.058F, head - 0.054F, -0.08F}, {width - 0.058F, head - gap, 0.08F});
        const glm::mat4 leaf = door * move({0.06F, 0, 0.085F}) * turn(-1.3F - 0.2F * d / length);
        b.box(leaf, m.wood, {0, 0.01F, 0}, {0.83F, 2.03F, 0.04F});
        for (const float z : {-0.05F, 0.05F})
            b.box(leaf, m.metal, {0.70F, 1.0F, z - 0.006F + 0.02F},
                  {0.80F, 1.02F, z + 0.006F + 0.02F});
    }
}

/// A stair of two flights between floor and floor, in a shaft of 2.6 by 5 m from its transform.
void add_stairs(MeshBuilder& b, const OfficeMaterials& m, const glm::mat4& at) {
    constexpr int steps = 10;
    const float rise = storey_height / (2 * steps);
    for (int flight = 0; flight < 2; ++flight) {
        const glm::mat4 f =
            flight == 0 ? at : at * move({2.6F, 0.5F * storey_height, 4.2F}) * turn(pi);
        // One saw-toothed solid: treads, risers and the sloping underside.
        Outline saw;
        for (int i = 0; i < steps; ++i) {
            const float z = 0.28F * static_cast<float>(i);
            saw.insert(saw.end(), {{z, rise * static_cast<float>(i) + 0.01F},
                                   {z, rise * static_cast<float>(i + 1)}});
        }
        saw.insert(
            saw.end(),
            {{0.28F * steps, rise * steps}, {0.28F * steps, rise * steps - 0.30F}, {0.32F, 0.01F}});
        Outline turned;
        for (auto p = saw.rbegin(); p != saw.rend(); ++p) turned.push_back(*p);
        b.prism(f * move({0.05F, 0, 1.2F}) * turn(-0.5F * pi) * glm::mat4(1), m.concrete, turned,
                -1.2F, 0);
        for (int i = 0; i <= steps; i += 1) {
            const float y = rise * static_cast<float>(i);
            const float z = 1.2F + 0.28F * static_cast<float>(i) - 0.1F;
            b.rod(m.metal, glm::vec3(f * glm::vec4(1.22F, y + gap, z, 1)),
                  glm::vec3(f * glm::vec4(1.22F, y + 0.92F, z, 1)), 0.012F, 6);
        }
        b.rod(m.metal, glm::vec3(f * glm::vec4(1.22F, 0.95F, 1.0F, 1)),
              glm::vec3(f * glm::vec4(1.22F, 0.95F + rise * steps, 1.1F + 0.28F * steps, 1)),
              0.025F, 10);
    }
    b.box(at, m.concrete, {0.05F, 0.5F * storey_height - 0.22F, 4.004F},
          {2.55F, 0.5F * storey_height, 5.2F});
}

void add_ceiling_lights(MeshBuilder& b, const OfficeMaterials& m, float y) {
    for (int i = 0; i < 10; ++i)
        for (int k = 0; k < 3; ++k) {
            const glm::mat4 at =
                move({-16.2F + 3.6F * static_cast<float>(i), y + clear_height - 0.35F,
                      2.2F + 2.0F * static_cast<float>(k)});
            b.box(at, m.metal, {-0.75F, 0, -0.08F}, {0.75F, 0.06F, 0.08F});
            for (const float x : {-0.6F, 0.6F})
                b.box(at, m.metal, {x - 0.004F, 0.064F, -0.004F}, {x + 0.004F, 0.345F, 0.004F},
                      all_faces & ~plus_y & ~minus_y);
        }
}

} // namespace

void add_building(MeshBuilder& b, const OfficeMaterials& m) {
    b.box(glm::mat4(1), m.concrete, {-half_length - 9, -0.4F, -half_depth - 5},
          {half_length + 6, -0.01F, half_depth + 8});
    for (int i = 0; i < 22; ++i) // paving before the entrance
        for (int k = 0; k < 6; ++k)
            b.box(move({-26.62F + 0.38F * static_cast<float>(i), 0,
                        -0.6F + 0.6F * static_cast<float>(k)}),
                  m.concrete, {0, -0.006F, 0}, {0.37F, 0.02F, 0.59F});
    // The shaft of the core is a hole in the slabs.
    const Outline edge = rounded_rectangle({-half_length - 0.25F, -half_depth - 0.25F},
                                           {half_length + 0.25F, half_depth + 0.25F}, 0.2F, 3);
    const Outline shaft = rectangle({-4.9F, 2.2F}, {-2.3F, 7.5F});
    for (int s = 0; s <= storeys; ++s) {
        const float top = floor_of(s);
        if (s == 0 || s == storeys)
            b.prism(lay_flat(), m.concrete, edge, top - (s == 0 ? 0.15F : slab), top);
        else
            b.prism(lay_flat(), m.concrete, edge, top - slab, top, std::span(&shaft, 1));
    }
    for (int s = 0; s < storeys; ++s) {
        const glm::mat4 at = move({0, floor_of(s), 0});
        for (int i = 0; i <= 6; ++i)
            for (int k = 0; k < 3; ++k) {
                const glm::vec3 p{-17.4F + 5.8F * static_cast<float>(i), 0,
                                  k == 0   ? -7.4F
                                  : k == 1 ? -1.6F
                                           : 7.4F};
                if (k == 1)
                    b.prism(at * move(p) * lay_flat(), m.concrete, circle({0, 0}, 0.22F, 20), gap,
                            clear_height - gap);
                else
                    b.box(at * move(p), m.concrete, {-0.2F, gap, -0.2F},
                          {0.2F, clear_height - gap, 0.2F});
            }
        add_facade(b, m, at * move({-half_length, 0, half_depth}), 2 * half_length, -1);
        add_facade(b, m, at * move({half_length, 0, -half_depth}) * turn(pi), 2 * half_length, -1);
        // The short sides stand between the corner posts of the long ones.
        const float depth = half_depth - 0.14F;
        add_facade(b, m, at * move({half_length, 0, depth}) * turn(0.5F * pi), 2 * depth, -1);
        add_facade(b, m, at * move({-half_length, 0, -depth}) * turn(-0.5F * pi), 2 * depth,
                   s == 0 ? 7 : -1);
        // The core: stairs, a lift and a store, behind walls.
        if (s + 1 < storeys)
            add_stairs(b, m, at * move({-4.9F, 0, -2.25F}) * turn(pi) * move({-2.6F, 0, 0}));
        const float front_doors[] = {0.8F, 4.2F, 6.6F};
        add_partition(b, m, at * move({-5.1F, 0, -2.0F}), 9.2F, front_doors);
        for (const float x : {-5.1F, -2.1F, 1.0F, 4.1F})
            add_partition(b, m, at * move({x, 0, -2.07F}) * turn(0.5F * pi), 5.7F, {});
        add_ceiling_lights(b, m, floor_of(s));
    }
    // The roof: a parapet and the plant on it.
    const float roof = floor_of(storeys);
    const Outline inner =
        rounded_rectangle({-half_length, -half_depth}, {half_length, half_depth}, 0.15F, 3);
    b.prism(lay_flat(), m.concrete, edge, roof + gap, roof + 0.9F, std::span(&inner, 1));
    b.box(move({-0.5F, roof, -4.6F}), m.plaster, {-4.6F, gap, -2.8F}, {4.6F, 2.6F, 2.6F});
    b.box(move({-0.5F, roof + 2.6F, -4.6F}), m.concrete, {-4.8F, gap, -3.0F}, {4.8F, 0.2F, 2.8F});
    for (int i = 0; i < 4; ++i) {
        const glm::mat4 unit = move({7.0F + 2.6F * static_cast<float>(i), roof, -4.0F});
        b.box(unit, m.metal, {-1, 0.2F, -1}, {1, 1.4F, 1});
        for (int k = 0; k < 9; ++k)
            b.box(unit, m.metal, {-0.9F, 0.3F + 0.11F * static_cast<float>(k), 1.01F},
                  {0.9F, 0.36F + 0.11F * static_cast<float>(k), 1.05F});
        const glm::vec2 fan[] = {
            {0.7F, 1.404F}, {0.7F, 1.6F}, {0.62F, 1.6F}, {0.62F, 1.45F}, {0, 1.45F}};
        b.lathe(unit, m.metal, fan, 20, true);
    }
    // A canopy over the entrance.
    b.box(glm::mat4(1), m.concrete, {-half_length - 3.2F, 2.86F, -1.0F},
          {-half_length - 0.27F, 3.02F, 3.4F});
    for (const float z : {-0.7F, 3.1F})
        b.rod(m.metal, {-half_length - 2.9F, 0.0F, z}, {-half_length - 2.9F, 2.856F, z}, 0.08F, 16);
}

void furnish(MeshBuilder& b, const OfficeMaterials& m, int storey) {
    const glm::mat4 floor = move({0, floor_of(storey), 0});
    std::uint32_t key = 1000U * static_cast<std::uint32_t>(storey + 1);
    auto island = [&](float x, float z) { // four desks, two and two face to face
        for (int i = 0; i < 4; ++i) {
            const float side = i < 2 ? 1.0F : -1.0F;
            const glm::mat4 seat = floor *
                                   move({x + (i % 2 == 0 ? -0.8F : 0.8F), 0, z + side * 0.41F}) *
                                   (side > 0 ? glm::mat4(1) : turn(pi));
            add_desk(b, m, seat, ++key);
            const float away = 0.62F + 0.22F * hash01(key, 21);
            add_chair(b, m,
                      seat * move({0.3F * (hash01(key, 22) - 0.5F), 0, away}) *
                          turn(1.6F * (hash01(key, 23) - 0.5F)));
        }
        b.box(floor * move({x, 0.76F, z}), m.fabric, {-1.55F, 0, -0.008F},
              {1.55F, 0.36F, 0.008F}); // screen
    };
    // South of the aisle: an open office along the facade.
    for (int i = 0; i < 5; ++i) {
        const float x = -14.0F + 6.6F * static_cast<float>(i);
        if (storey == 0 && i == 0) continue; // the lobby
        if ((storey + i) % 5 == 2) {         // a corner to sit in
            add_sofa(b, m, floor * move({x, 0, 6.6F}));
            add_sofa(b, m, floor * move({x, 0, 3.6F}) * turn(pi));
            add_plant(b, m, floor * move({x + 1.6F, 0, 6.6F}), ++key);
            continue;
        }
        island(x, 4.9F);
        add_plant(b, m, floor * move({x + 2.9F, 0, 6.9F}), ++key);
        add_shelf(b, m, floor * move({x + 2.5F, 0, 4.4F}) * turn(0.5F * pi), ++key);
        if (i % 2 == 0)
            add_shelf(b, m, floor * move({x + 2.5F, 0, 5.45F}) * turn(0.5F * pi), ++key);
    }
    // North-west: more desks. North-east: rooms behind a partition.
    for (const float x : {-15.0F, -10.4F}) {
        if (storey == 0 && x < -12) continue;
        if (x < -12 && storey != 2)
            island(x, -4.6F);
        else
            add_meeting_table(b, m, floor * move({x + 0.8F, 0, -4.8F}), 2.4F);
        for (int i = 0; i < 3; ++i)
            add_shelf(b, m, floor * move({x - 1.1F + 1.05F * static_cast<float>(i), 0, -7.55F}),
                      ++key);
    }
    const float doors[] = {1.4F, 5.9F, 10.4F};
    add_partition(b, m, floor * move({4.4F, 0, -2.0F}), 13.4F, doors);
    for (const float x : {8.9F, 13.4F})
        add_partition(b, m, floor * move({x, 0, -2.07F}) * turn(0.5F * pi), 5.75F, {});
    add_meeting_table(
        b, m, floor * move({6.6F, 0, -5.0F}) * turn(storey % 2 == 0 ? 0.0F : 0.5F * pi), 2.6F);
    add_meeting_table(b, m, floor * move({11.1F, 0, -5.0F}), 2.5F);
    add_desk(b, m, floor * move({15.6F, 0, -4.6F}) * turn(pi), ++key);
    add_chair(b, m, floor * move({15.6F, 0, -5.3F}) * turn(pi + 0.3F));
    add_sofa(b, m, floor * move({15.8F, 0, -2.75F}));
    for (int i = 0; i < 3; ++i)
        add_shelf(b, m, floor * move({5.0F + 4.5F * static_cast<float>(i), 0, -7.55F}), ++key);
    if (storey == 0) { // the lobby: reception, sofas, plants
        b.box(floor * move({-13.6F, 0, -3.0F}), m.wood, {-1.8F, gap, -0.35F}, {1.8F, 1.05F, 0.3F});
        b.box(floor * move({-13.6F, 1.06F, -3.0F}), m.plaster, {-1.9F, 0, -0.42F},
              {1.9F, 0.04F, 0.38F});
        add_chair(b, m, floor * move({-13.0F, 0, -4.0F}) * turn(pi));
        add_sofa(b, m, floor * move({-15.2F, 0, 6.6F}));
        add_sofa(b, m, floor * move({-13.0F, 0, 4.6F}) * turn(0.5F * pi));
        add_plant(b, m, floor * move({-16.9F, 0, 3.6F}), ++key);
        add_plant(b, m, floor * move({-16.9F, 0, -1.6F}), ++key);
        for (int i = 0; i < 3; ++i)
            add_shelf(b, m, floor * move({-15.0F + 1.05F * static_cast<float>(i), 0, -7.55F}),
                      ++key);
    }
    for (const float x : {-8.0F, 4.6F, 9.0F, 16.7F})
        add_plant(b, m, floor * move({x, 0, -1.3F}), ++key);
}

} // namespace lineatlas::scenes
