// What stands on the main deck: hatches, deckhouses, boats, capstan, wheel, rails and cargo gear.
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ship_parts.hpp"

namespace lineatlas::scenes {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

float deck_at(float x) {
    return hull::sheer(x) - hull::bulwark + 0.15F;
}

void add_hatch(MeshBuilder& b, const ShipMaterials& m, const Hatch& h, int cover) {
    const float y = deck_at(h.x0);
    const float w = h.half_width;
    const glm::mat4 at(1);
    for (const float side : {-1.0F, 1.0F})
        b.box(at, m.joinery, {h.x0 - 0.12F, y - 0.55F, side * (w + 0.06F) - 0.06F},
              {h.x1 + 0.12F, y + 0.62F, side * (w + 0.06F) + 0.06F});
    for (const float x : {h.x0 - 0.06F, h.x1 + 0.06F})
        b.box(at, m.joinery, {x - 0.06F, y - 0.55F, -w + gap}, {x + 0.06F, y + 0.62F, w - gap});
    // Boards fore and aft of the coamings, over the ends of the deck planks.
    for (const float end : {h.x0 - 1.02F, h.x1 + 0.124F}) {
        const float deck = deck_at(end + 0.45F);
        b.box(at, m.joinery, {end, deck - 0.06F, -w - 0.20F},
              {end + 0.896F, deck + 0.03F, w + 0.20F});
    }
    const int n = static_cast<int>((h.x1 - h.x0) / 0.12F);
    if (cover == 1) { // grating
        for (int i = 0; i < n; ++i)
            b.box(move({h.x0 + 0.12F * static_cast<float>(i) + 0.03F, y + 0.54F, 0}), m.deck,
                  {0, 0, -w + 0.01F}, {0.06F, 0.05F, w - 0.01F});
        for (int i = 0; i < static_cast<int>(2 * w / 0.14F); ++i)
            b.box(move({0, y + 0.51F, -w + 0.05F + 0.14F * static_cast<float>(i)}), m.deck,
                  {h.x0 + 0.01F, 0, 0}, {h.x1 - 0.01F, 0.026F, 0.05F});
    } else if (cover == 2) { // boards, with three of them taken off
        for (int i = 0; i < n / 2 - 3; ++i)
            b.box(move({h.x0 + 0.24F * static_cast<float>(i), y + 0.56F, 0}), m.deck,
                  {gap, 0, -w + 0.01F}, {0.235F, 0.06F, w - 0.01F});
    }
}

/// Walls between corner posts, with windows and a door; a cambered roof of planks.
void add_deckhouse(MeshBuilder& b, const ShipMaterials& m, float x0, float x1, float half,
                   float height) {
    const float y = deck_at(0.5F * (x0 + x1)) - 0.02F;
    auto wall = [&](const glm::mat4& at, float length, int windows, bool door) {
        Outline outline{{0.1F, 0.12F}};
        if (door) {
            const float d = 0.5F * length;
            outline.insert(
                outline.end(),
                {{d - 0.45F, 0.12F}, {d - 0.45F, 1.95F}, {d + 0.45F, 1.95F}, {d + 0.45F, 0.12F}});
        }
        outline.insert(outline.end(),
                       {{length - 0.1F, 0.12F}, {length - 0.1F, height}, {0.1F, height}});
        std::vector<Outline> holes;
        for (int k = 0; k < windows; ++k) {
            const float centre =
                length * (static_cast<float>(k) + 0.5F) / static_cast<float>(windows);
            holes.push_back(rectangle({centre - 0.33F, 0.92F}, {centre + 0.33F, 1.58F}));
        }
        b.prism(at, m.planking, outline, -0.05F, 0, holes);
        b.box(at, m.joinery, {0.094F, 0, -0.07F}, {length - 0.094F, 0.115F, 0.033F});
        for (int k = 0; k < windows; ++k) {
            const float centre =
                length * (static_cast<float>(k) + 0.5F) / static_cast<float>(windows);
            const glm::mat4 frame = at * move({centre, 1.25F, 0.005F});
            for (const float side : {-1.0F, 1.0F}) {
                b.box(frame, m.joinery, {side * 0.36F - 0.04F, -0.36F, 0},
                      {side * 0.36F + 0.04F, 0.36F, 0.05F});
                b.box(frame, m.joinery, {-0.32F + gap, side * 0.32F - 0.04F, 0},
                      {0.32F - gap, side * 0.32F + 0.04F, 0.045F});
            }
            b.box(frame, m.joinery, {-0.015F, -0.276F, -0.02F}, {0.015F, 0.276F, 0.01F});
            b.box(frame, m.joinery, {-0.316F, -0.015F, -0.03F}, {0.316F, 0.015F, -0.022F});
        }
        if (door) {
            b.box(at * move({0.5F * length + 0.42F, 0.12F, 0.02F}) * turn(-1.9F), m.joinery,
                  {-0.8F, 0.02F, 0}, {0, 1.80F, 0.04F});
            for (const float side : {-1.0F, 1.0F})
                b.box(at * move({0.5F * length + side * 0.50F, 0.12F, 0.005F}), m.joinery,
                      {-0.05F, 0, 0}, {0.05F, 1.9F, 0.06F});
        }
    };
    const float length = x1 - x0;
    wall(move({x0, y, half}), length, static_cast<int>(length / 1.3F), false);
    wall(move({x1, y, -half}) * turn(pi), length, static_cast<int>(length / 1.3F), false);
    wall(move({x1, y, half}) * turn(0.5F * pi), 2 * half, 0, true);
    wall(move({x0, y, -half}) * turn(-0.5F * pi), 2 * half, 2, false);
    for (const float x : {x0, x1})
        for (const float z : {-half, half})
            b.box(move({x, y, z}), m.joinery, {-0.09F, 0, -0.09F}, {0.09F, height - gap, 0.09F});
    const int planks = static_cast<int>((2 * half + 0.5F) / 0.4F);
    for (int i = 0; i < planks; ++i) {
        const float z = -half - 0.25F + 0.4F * static_cast<float>(i);
        const float camber = 0.10F * (1 - (z + 0.2F) * (z + 0.2F) / (half * half));
        b.box(move({0, y + height + gap + 0.10F + camber, z}), m.deck, {x0 - 0.25F, -0.06F, 0.002F},
              {x1 + 0.25F, 0, 0.398F});
    }
}

/// A ship's boat, clinker built, with thwarts, on chocks.
void add_boat(MeshBuilder& b, const ShipMaterials& m, const glm::mat4& at, float length) {
    auto form = [length](float u, float h) {
        const float s = 2 * u - 1;
        const float plan = 1 - std::pow(std::abs(s), s > 0 ? 2.4F : 3.2F);
        return glm::vec3(0.5F * length * s * (0.86F + 0.14F * h), 0.75F * h + 0.22F * s * s * h,
                         0.02F + 0.85F * plan * std::sqrt(1 - (1 - h) * (1 - h)));
    };
    for (const float side : {-1.0F, 1.0F})
        for (int strake = 0; strake < 6; ++strake) {
            Path lower;
            Path upper;
            for (int i = 0; i <= 24; ++i) {
                const float u = static_cast<float>(i) / 24;
                glm::vec3 a = form(u, static_cast<float>(strake) / 6 * 0.98F);
                glm::vec3 c = form(u, static_cast<float>(strake + 1) / 6);
                a.z = side * (a.z + 0.012F);
                c.z *= side;
                lower.push_back(a);
                upper.push_back(c);
            }
            if (side > 0)
                b.strip(at, m.planking, lower, upper);
            else
                b.strip(at, m.planking, upper, lower);
        }
    for (int i = 0; i < 6; ++i) {
        const float u = 0.16F + 0.13F * static_cast<float>(i);
        const glm::vec3 p = form(u, 0.7F);
        b.box(at * move({p.x, p.y, 0}), m.deck, {-0.12F, -0.02F, -p.z + 0.10F},
              {0.12F, 0.02F, p.z - 0.10F});
    }
    for (const float x : {-0.28F, 0.28F})
        b.box(at * move({x * length, -0.32F, 0}), m.joinery, {-0.08F, 0, -0.6F},
              {0.08F, 0.30F, 0.6F});
}

/// Racks of belaying pins with coiled lines, along the bulwark beside a mast.
void add_pin_rail(MeshBuilder& b, const ShipMaterials& m, float x0, float x1, float side) {
    const int pins = static_cast<int>((x1 - x0) / 0.45F);
    for (int i = 0; i < pins; ++i) {
        const float x = x0 + 0.45F * (static_cast<float>(i) + 0.5F);
        const float y = hull::sheer(x) - 0.22F;
        const float z = side * (hull::half_breadth(x, y) - 0.58F);
        b.box(move({x, y, z}), m.joinery, {-0.223F, -0.03F, -0.09F}, {0.223F, 0.03F, 0.09F});
        const glm::vec2 pin[] = {{0, -0.24F},     {0.014F, -0.23F}, {0.016F, 0.03F},
                                 {0.026F, 0.06F}, {0.022F, 0.16F},  {0, 0.20F}};
        b.lathe(move({x, y, z}), m.spars, pin, 6, true);
        Path coil;
        for (const glm::vec2& p : circle({0, 0}, 0.11F, 10))
            coil.emplace_back(p.x, 1.9F * p.y - 0.20F, 0.0F);
        b.tube(move({x, y - 0.02F, z - side * 0.13F}), m.rope, coil, 0.028F, 4, true);
    }
}

void add_wheel(MeshBuilder& b, const ShipMaterials& m, const glm::mat4& at) {
    Path rim;
    for (const glm::vec2& p : circle({0, 0}, 0.55F, 24)) rim.emplace_back(p, 0.0F);
    b.tube(at, m.joinery, rim, 0.035F, 8, true);
    for (const glm::vec2& p : circle({0, 0}, 1, 10)) {
        const glm::vec3 d(p, 0);
        const glm::vec2 spoke[] = {{0.02F, 0.10F}, {0.030F, 0.3F}, {0.02F, 0.5F},
                                   {0.020F, 0.6F}, {0.028F, 0.7F}, {0, 0.78F}};
        b.lathe(at * along({}, d), m.joinery, spoke, 8, true);
    }
    const glm::vec2 hub[] = {{0, -0.16F}, {0.09F, -0.14F}, {0.12F, 0}, {0.09F, 0.14F}, {0, 0.16F}};
    b.lathe(at * turn(0.5F * pi, {1, 0, 0}), m.iron, hub, 16, true);
}

} // namespace

void add_coil(MeshBuilder& b, const ShipMaterials& m, const glm::mat4& at, float radius, int turns,
              int segments) {
    for (int i = 0; i < turns; ++i) {
        Path path;
        for (const glm::vec2& p :
             circle({0, 0}, radius - 0.012F * static_cast<float>(i % 2), segments))
            path.emplace_back(p.x, 0.064F * static_cast<float>(i) + 0.04F, -p.y);
        b.tube(at, m.rope, path, 0.030F, 4, true);
    }
}

void add_deck_gear(MeshBuilder& b, const ShipMaterials& m) {
    add_hatch(b, m, hatches[0], 2);
    add_hatch(b, m, hatches[1], 0);
    add_hatch(b, m, hatches[2], 1);
    add_deckhouse(b, m, 4.2F, 8.2F, 1.75F, 2.0F);
    add_deckhouse(b, m, -22.5F, -18.3F, 2.0F, 2.0F);
    for (const float side : {-1.0F, 1.0F}) {
        add_boat(b, m, move({6.2F, deck_at(6.2F) + 2.55F, side * 0.98F}), 5.4F);
        for (const float x : {13.8F, 0.2F, -14.4F}) add_pin_rail(b, m, x, x + 3.0F, side);
        // Cathead and anchor.
        const float y = hull::sheer(24);
        const float z = hull::half_breadth(24, y - 0.3F);
        b.box(move({24, y + 0.12F, side * (z + 0.2F)}) * turn(side * 0.3F), m.joinery,
              {-0.14F, 0, -0.9F}, {0.14F, 0.26F, 0.9F});
        const glm::mat4 anchor = move({24.2F, y - 0.5F, side * (z + 0.95F)});
        b.rod(m.iron, {24.2F, y - 2.6F, side * (z + 0.95F)}, {24.2F, y - 0.1F, side * (z + 0.95F)},
              0.07F, 8);
        lay(b, m, {24.2F, y - 0.1F, side * (z + 0.95F)}, {24.2F, y + 0.12F, side * (z + 0.95F)},
            0.03F);
        Path arms;
        for (int i = 0; i <= 10; ++i) {
            const float angle = pi * (1.1F + 0.08F * static_cast<float>(i));
            arms.emplace_back(0.95F * std::cos(angle), -1.2F + 0.95F * std::sin(angle), 0.0F);
        }
        b.tube(anchor, m.iron, arms, 0.075F, 8);
        b.box(anchor, m.joinery, {-0.08F, 0.1F, -0.8F}, {0.08F, 0.26F, 0.8F});
    }
    add_coil(b, m, move({11.0F, deck_at(11), 2.9F}), 0.42F, 4);
    add_coil(b, m, move({-2.0F, deck_at(-2), -3.4F}), 0.38F, 3);
    add_coil(b, m, move({19.5F, deck_at(19.5F), 1.9F}), 0.45F, 4);

    // Capstan on the forecastle, windlass before the fore mast.
    const glm::vec2 capstan[] = {{0, 0},         {0.62F, 0},     {0.60F, 0.12F}, {0.34F, 0.22F},
                                 {0.28F, 0.55F}, {0.36F, 0.80F}, {0.50F, 0.84F}, {0.50F, 1.02F},
                                 {0.1F, 1.10F},  {0, 1.11F}};
    b.lathe(move({21.6F, deck_at(21.6F), 0}), m.joinery, capstan, 20, true);
    for (const glm::vec2& p : circle({0, 0}, 1, 8)) {
        const glm::vec3 hub{21.6F, deck_at(21.6F) + 0.93F, 0};
        b.rod(m.spars, hub + 0.45F * glm::vec3(p.x, 0, p.y), hub + 1.7F * glm::vec3(p.x, 0, p.y),
              0.035F, 8);
    }
    b.rod(m.joinery, {18.4F, deck_at(18.4F) + 0.6F, -1.5F}, {18.4F, deck_at(18.4F) + 0.6F, 1.5F},
          0.24F, 12);
    for (const float z : {-1.7F, 1.7F})
        b.box(move({18.4F, deck_at(18.4F), z}), m.joinery, {-0.22F, 0, -0.14F},
              {0.22F, 1.15F, 0.14F});

    // Wheel, binnacle and skylight aft.
    const float aft = deck_at(-24.6F);
    add_wheel(b, m, move({-24.6F, aft + 0.95F, 0}) * turn(0.5F * pi));
    b.box(move({-24.95F, aft, 0}), m.joinery, {-0.2F, 0, -0.3F}, {0.12F, 1.0F, 0.3F});
    const glm::vec2 binnacle[] = {{0.24F, 0},    {0.24F, 0.1F}, {0.17F, 0.16F}, {0.17F, 0.9F},
                                  {0.22F, 1.0F}, {0.20F, 1.2F}, {0, 1.34F}};
    b.lathe(move({-23.4F, deck_at(-23.4F), 0}), m.joinery, binnacle, 14, true);

    // The cargo derrick over the main hatch, with its tackle.
    const glm::vec3 heel{2.0F, deck_at(2) + 1.6F, 0};
    const glm::vec3 head{-2.4F, deck_at(0) + 9.5F, 0};
    const glm::vec2 boom[] = {{0, 0}, {0.13F, 0.05F}, {0.15F, 4}, {0.09F, 8.7F}, {0, 8.75F}};
    b.lathe(along(heel, head), m.spars, boom, 12, true);
    b.rope(m.rope, head, {2.26F, deck_at(2) + 12.5F, 0}, 0.02F, 1);
    for (const float z : {-0.06F, 0.06F})
        b.rope(m.rope, head + glm::vec3(0, -0.2F, z), {head.x, deck_at(0) + 3.1F, z}, 0.012F, 1);
    const glm::vec2 block[] = {
        {0, -0.16F}, {0.10F, -0.10F}, {0.12F, 0}, {0.10F, 0.10F}, {0, 0.16F}};
    b.lathe(move(head + glm::vec3(0, -0.25F, 0)), m.joinery, block, 10, true);
    b.lathe(move({head.x, deck_at(0) + 3.0F, 0}), m.joinery, block, 10, true);
    Path hook;
    for (int i = 0; i < 12; ++i) {
        const float angle = 0.5F * pi - 0.42F * static_cast<float>(i);
        hook.emplace_back(0.11F * std::cos(angle), 0.11F * std::sin(angle) - 0.30F, 0.0F);
    }
    b.tube(move({head.x, deck_at(0) + 3.0F, 0}), m.iron, hook, 0.022F, 8);
    // Buckets along the break of the house and harness casks.
    for (int i = 0; i < 6; ++i) {
        const glm::vec2 bucket[] = {{0, 0.02F},      {0.12F, 0},     {0.15F, 0.28F},
                                    {0.135F, 0.28F}, {0.11F, 0.05F}, {0, 0.05F}};
        b.lathe(move({3.7F, deck_at(3.7F), -1.4F + 0.5F * static_cast<float>(i)}), m.cargo, bucket,
                12, true);
    }
}

} // namespace lineatlas::scenes
