// Decks and what lies below them: beams, pillars, ladders, cabins and the cargo in the hold.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ship_parts.hpp"

namespace lineatlas::scenes {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

float deck_height(float x, float z, float drop) {
    return hull::sheer(x) - hull::bulwark - drop + 0.14F - 0.005F * z * z;
}

/// Planks along the ship. Each tucks 4 mm under its neighbour so that nothing shines through.
void add_deck(MeshBuilder& b, const ShipMaterials& m, float drop, float first, float last) {
    constexpr float width = 0.165F;
    for (int row = -33; row < 33; ++row) {
        const float z = width * static_cast<float>(row);
        const float far_side = std::max(std::abs(z), std::abs(z + width));
        auto covered = [&](float x) {
            return hull::half_breadth(x, deck_height(x, z, drop)) - 0.46F > far_side &&
                   !hull::in_hatch(x, z + 0.5F * width, 0.08F);
        };
        Path left;
        Path right;
        int planks = static_cast<int>(hash01(5, static_cast<std::uint32_t>(row + 99)) * 7);
        auto finish = [&] {
            if (left.size() > 1) b.strip(glm::mat4(1), m.deck, right, left);
            left.clear();
            right.clear();
        };
        for (float x = first; x < last; x += 0.8F) {
            if (!covered(x)) {
                finish();
                continue;
            }
            if (left.size() > 7 || (left.size() > 2 && ++planks % 9 == 0)) {
                finish();
                x -= 0.797F; // the next plank butts against the last one
            }
            const float y = deck_height(x, z, drop);
            left.emplace_back(x, y, z);
            right.emplace_back(x, deck_height(x, z + width, drop) - 0.003F, z + width + 0.004F);
        }
        finish();
    }
    // The waterway along the ship's side covers the stepped ends of the planks.
    for (const float side : {-1.0F, 1.0F}) {
        Path inner;
        Path outer;
        for (float x = first - 0.2F; x < last + 0.6F; x += 0.9F) {
            const float half = hull::half_breadth(x, deck_height(x, 0, drop)) - 0.455F;
            if (half < 0.2F) continue;
            const float near_side = std::max(0.02F, half - 0.52F);
            outer.emplace_back(x, deck_height(x, half, drop) + 0.05F, side * half);
            inner.emplace_back(x, deck_height(x, near_side, drop) + 0.03F, side * near_side);
        }
        if (side > 0)
            b.strip(glm::mat4(1), m.joinery, outer, inner);
        else
            b.strip(glm::mat4(1), m.joinery, inner, outer);
    }
    // Beams below, with hanging knees at their ends.
    for (float x = first + 1; x < last; x += 1.15F) {
        const float half = hull::half_breadth(x, deck_height(x, 0, drop) - 0.3F) - 0.48F;
        if (half < 0.7F) continue;
        for (const float side : {-1.0F, 1.0F}) {
            const float from = hull::in_hatch(x, 0, 0.2F) ? 2.0F : 0.03F;
            if (half < from + 0.5F) continue;
            for (int k = 0; k < 3; ++k) {
                const float z0 = glm::mix(from, half, static_cast<float>(k) / 3) + gap;
                const float z1 = glm::mix(from, half, static_cast<float>(k + 1) / 3);
                const float y = deck_height(x, z1, drop);
                b.box(glm::mat4(1), m.frames,
                      {x - 0.12F, y - 0.30F, std::min(side * z0, side * z1)},
                      {x + 0.12F, y - 0.02F, std::max(side * z0, side * z1)}, all_faces & ~plus_y);
            }
            // Boards line the underside of the deck from beam to beam.
            for (float z = from; z + 0.06F < half - 0.3F; z += 0.06F) {
                const float level = deck_height(x, z, drop) - 0.10F;
                const float z0 = side * z;
                const float z1 = side * (z + 0.056F);
                b.open_quad(glm::mat4(1), m.ceiling, {x + 0.125F, level, std::min(z0, z1)},
                            {x + 1.025F, level, std::min(z0, z1)},
                            {x + 1.025F, level, std::max(z0, z1)},
                            {x + 0.125F, level, std::max(z0, z1)});
            }
            const float y = deck_height(x, half, drop) - 0.32F;
            // No knees under the counter, where the side falls away below the beam.
            if (hull::half_breadth(x, y - 1.0F) < half + 0.12F) continue;
            const glm::mat4 at =
                move({x, y, side * half}) * turn(side > 0 ? -0.5F * pi : 0.5F * pi);
            b.prism(at, m.frames,
                    {{0, -1.0F},
                     {0, 0},
                     {-0.9F, 0},
                     {-0.86F, -0.16F},
                     {-0.42F, -0.32F},
                     {-0.2F, -0.62F},
                     {-0.14F, -1.0F}},
                    -0.07F, 0.07F);
        }
    }
}

void add_crate(MeshBuilder& b, const ShipMaterials& m, const glm::mat4& at, glm::vec3 half) {
    // No face lies against another: it would cost two triangles and show nothing.
    b.box(at, m.cargo, -half, half, open_below);
    for (const float side : {-1.0F, 1.0F}) {
        const float x = side * (half.x + 0.016F);
        const unsigned inner = all_faces & ~(side > 0 ? minus_x : plus_x);
        for (const float edge : {-1.0F, 1.0F}) { // battens on two faces
            b.box(at * move({x, edge * (half.y - 0.07F), 0}), m.cargo, {-0.012F, -0.06F, -half.z},
                  {0.012F, 0.06F, half.z}, inner);
            b.box(at * move({x, 0, edge * (half.z - 0.06F)}), m.cargo,
                  {-0.012F, -half.y + 0.135F, -0.06F}, {0.012F, half.y - 0.135F, 0.06F}, inner);
        }
        for (int i = 1; i < 4; ++i) { // joints of the boards
            const float y = glm::mix(-half.y, half.y, static_cast<float>(i) / 4);
            const float board = std::min(0.05F, 0.2F * half.y);
            b.box(at * move({0, y, side * (half.z + 0.006F)}), m.cargo, {-half.x, -board, -0.004F},
                  {half.x, board, 0.004F}, all_faces & ~(side > 0 ? minus_z : plus_z));
        }
    }
}

void add_barrel(MeshBuilder& b, const ShipMaterials& m, const glm::mat4& at) {
    const glm::vec2 staves[] = {{0, 0.05F},      {0.26F, 0.05F}, {0.28F, 0},
                                {0.335F, 0.22F}, {0.36F, 0.45F}, {0.335F, 0.68F},
                                {0.28F, 0.90F},  {0.26F, 0.85F}, {0, 0.85F}};
    b.lathe(at, m.cargo, staves, 10, true);
    for (const float y : {0.16F, 0.70F}) {
        const float r = 0.30F + 0.075F * (1 - 4 * (y + 0.02F - 0.45F) * (y + 0.02F - 0.45F));
        const glm::vec2 hoop[] = {{r, y}, {r, y + 0.045F}};
        b.lathe(at, m.iron, hoop, 10);
    }
}

void add_sack(MeshBuilder& b, const ShipMaterials& m, const glm::mat4& at) {
    b.panel(at, m.sacks, 6, 5, [](float u, float v) {
        const float angle = 2 * pi * v;
        const float s = 2 * u - 1;
        const float r = 0.05F + 0.23F * std::sqrt(std::max(0.0F, 1 - s * s * s * s));
        return glm::vec3(0.46F * s, 0.24F + 0.82F * r * std::sin(angle),
                         1.25F * r * std::cos(angle + pi));
    });
}

void add_ladder(MeshBuilder& b, const ShipMaterials& m, glm::vec3 foot, glm::vec3 head) {
    for (const float side : {-0.32F, 0.32F}) {
        const glm::vec3 offset{0, 0, side};
        const glm::mat4 at = along(foot + offset, head + offset);
        b.box(at, m.joinery, {-0.03F, 0, -0.09F}, {0.03F, glm::distance(foot, head), 0.09F});
    }
    const int steps = static_cast<int>((head.y - foot.y) / 0.26F);
    for (int i = 1; i <= steps; ++i) {
        const glm::vec3 p =
            glm::mix(foot, head, static_cast<float>(i) / static_cast<float>(steps + 1));
        b.box(move(p), m.joinery, {-0.11F, -0.02F, -0.28F}, {0.11F, 0.02F, 0.28F});
    }
}

/// A wall of tongued boards across the ship, with a doorway.
void add_bulkhead(MeshBuilder& b, const ShipMaterials& m, float x, float drop, float height) {
    const float floor = deck_height(x, 0, drop) + 0.02F;
    for (int i = -26; i < 26; ++i) {
        const float z = 0.2F * static_cast<float>(i);
        if (std::abs(z + 0.1F) < 0.45F) continue; // the doorway
        if (hull::half_breadth(x, floor) - 0.6F < std::abs(z + 0.1F)) continue;
        b.box(move({x, floor - 0.006F * z * z, z}), m.joinery, {-0.03F, 0, 0.003F},
              {0.03F, height, 0.197F});
    }
}

void add_cabin_furniture(MeshBuilder& b, const ShipMaterials& m, float x, float side, float drop) {
    const float z = side * (hull::half_breadth(x, deck_height(x, 0, drop)) - 1.15F);
    const glm::mat4 at = move({x, deck_height(x, z, drop) + 0.02F, z});
    for (const float y : {0.35F, 1.15F}) { // two bunks with mattresses
        b.box(at * move({0, y, 0}), m.joinery, {-1.0F, 0, -0.4F}, {1.0F, 0.08F, 0.4F});
        b.box(at * move({0, y, -side * 0.42F}), m.joinery, {-1.0F, 0.0F, -0.015F},
              {1.0F, 0.26F, 0.015F});
        b.panel(at * move({0, y + 0.1F, 0}), m.sacks, 12, 8, [](float u, float v) {
            const float pillow = u > 0.8F ? 0.09F : 0.02F * std::sin(17 * u);
            const float edge = std::sin(pi * v) * std::sin(pi * u);
            return glm::vec3(1.94F * (u - 0.5F),
                             (0.10F + pillow) * std::pow(std::max(0.0F, edge), 0.3F),
                             -0.74F * (v - 0.5F));
        });
    }
    for (const float end : {-1.04F, 1.04F})
        for (const float edge : {-0.38F, 0.38F})
            b.box(at * move({end, 0, edge}), m.joinery, {-0.03F, 0, -0.03F}, {0.03F, 1.7F, 0.03F});
    add_crate(b, m, at * move({0, 0.2F, -side * 0.8F}), {0.4F, 0.18F, 0.25F}); // sea chest
}

} // namespace

void add_decks(MeshBuilder& b, const ShipMaterials& m) {
    add_deck(b, m, 0, -28.3F, 27.4F);
    add_deck(b, m, hull::tween, -26.0F, 25.0F);
    for (float x = -20; x < 20; x += 2.3F) { // pillars under the beams
        if (hull::in_hatch(x, 0, 0.3F)) continue;
        for (const float z : {-1.2F, 1.2F}) {
            const float top = deck_height(x, z, 0) - 0.33F;
            const float middle = deck_height(x, z, hull::tween);
            b.rod(m.frames, {x, middle + 0.02F, z}, {x, top, z}, 0.10F, 10);
            float foot = -4.28F; // or where the side of the ship comes in
            while (hull::half_breadth(x, foot) < 1.9F) foot += 0.1F;
            b.rod(m.frames, {x, foot, z}, {x, middle - 0.33F, z}, 0.12F, 10);
        }
    }
    for (const Hatch& hatch : hatches) {
        const float x = hatch.x1 - 0.5F;
        add_ladder(b, m, {x - 1.3F, deck_height(x, 0, hull::tween), 0},
                   {x, deck_height(x, 0, 0), 0});
        add_ladder(b, m, {x - 1.6F, -4.0F, 0.8F}, {x, deck_height(x, 0, hull::tween), 0.8F});
    }
    for (const float x : {-24.0F, -21.5F, -18.0F, 14.5F, 18.0F, 21.0F})
        add_bulkhead(b, m, x, hull::tween, 2.0F);
    for (const float x : {-22.8F, -19.7F, 16.2F, 19.4F})
        for (const float side : {-1.0F, 1.0F}) add_cabin_furniture(b, m, x, side, hull::tween);
}

void add_hold(MeshBuilder& b, const ShipMaterials& m) {
    // Cargo in tiers, from the ceiling up; the hatchways stay free from the 'tween deck upwards.
    for (int level = 0; level < 5; ++level) {
        const bool tween = level >= 3;
        const float bottom = tween ? 0 : -4.25F + 0.98F * static_cast<float>(level);
        for (int i = -17; i <= (tween ? 11 : 16); ++i) {
            if (tween && i < -13) continue;
            for (int k = -3; k <= 3; ++k) {
                const float x = 1.18F * static_cast<float>(i);
                const float z = 1.18F * static_cast<float>(k);
                const auto key = static_cast<std::uint32_t>((i + 40) * 16 + k + 8);
                const float pick = hash01(11, key, static_cast<std::uint32_t>(level));
                const float y =
                    tween ? deck_height(x, z, hull::tween) + 0.02F + (level == 4 ? 0.95F : 0)
                          : bottom;
                if (hull::half_breadth(x, y) - 0.55F < std::abs(z) + 0.62F) continue;
                if (hull::in_hatch(x, z, 0.8F) && (tween || level == 2)) continue;
                if (std::abs(z) > 1 && std::abs(z) < 1.4F && !tween && level == 2) continue;
                if (!tween && pick < 0.26F) continue;
                if (tween && (k == 0 || pick < (level == 4 ? 0.80F : 0.35F))) continue;
                const glm::mat4 at = move({x, y, z}) * turn(0.10F * (hash01(12, key) - 0.5F));
                const int kind = (i + 40) / 4 % 3;
                if (kind == 0)
                    add_crate(b, m, at * move({0, 0.46F, 0}), {0.5F, 0.45F, 0.5F});
                else if (kind == 1)
                    add_barrel(b, m, at);
                else
                    for (int layer = 0; layer < 2; ++layer)
                        for (const float side : {-0.29F, 0.29F})
                            add_sack(b, m,
                                     at * move({0, 0.47F * static_cast<float>(layer), side}) *
                                         turn(0.12F * (pick - 0.5F)));
            }
        }
    }
    // Ballast: iron pigs in the bilge.
    for (int i = -30; i < 30; ++i)
        for (const float z : {-0.35F, 0.0F, 0.35F})
            b.box(move({0.52F * static_cast<float>(i), -4.48F, z}), m.iron, {0, 0, -0.15F},
                  {0.49F, 0.14F, 0.15F}, open_below);
}

} // namespace lineatlas::scenes
