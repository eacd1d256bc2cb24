// Masts, yards and the standing and running rigging.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ship_parts.hpp"

namespace lineatlas::scenes {

namespace {

struct Mast {
    float x;
    float height; ///< of the truck above the deck
    float lower;  ///< height of the top (the platform)
    float upper;  ///< height of the crosstrees
};
constexpr Mast masts[] = {
    {16.5F, 34, 12.5F, 22.5F}, {2.6F, 37, 13.5F, 24.5F}, {-12.0F, 30, 11, 20}};

float deck_at(float x) {
    return hull::sheer(x) - hull::bulwark;
}

/// A yard tapers towards its arms.
void add_yard(MeshBuilder& b, const ShipMaterials& m, glm::vec3 middle, float half, float radius) {
    const glm::mat4 at = along(middle - glm::vec3(0, 0, half), middle);
    glm::vec2 profile[9];
    for (int i = 0; i < 9; ++i) {
        const float s = static_cast<float>(i) / 4 - 1;
        profile[i] = {radius * (1 - 0.55F * s * s * std::abs(s)), half * (s + 1)};
    }
    b.lathe(at, m.spars, profile, 14, true);
    // Footrope below, with its stirrups, and lifts above.
    for (const float side : {-1.0F, 1.0F}) {
        const glm::vec3 arm = middle + glm::vec3(0.1F, 0, side * half * 0.94F);
        const glm::vec3 slings = middle + glm::vec3(0.1F, 0, side * 0.5F);
        lay(b, m, slings, arm, 0.018F, 0.55F);
        for (int i = 1; i < 4; ++i) {
            const float s = static_cast<float>(i) / 4;
            const glm::vec3 p = glm::mix(slings, arm, s);
            lay(b, m, p, p - glm::vec3(0, 2.2F * s * (1 - s), 0), 0.012F);
        }
        lay(b, m, arm + glm::vec3(-0.1F, 0.15F, 0),
            middle + glm::vec3(-0.3F, 0.42F * half, side * 0.12F), 0.016F);
    }
}

/// A fan of shrouds with ratlines tied between neighbours.
void add_shrouds(MeshBuilder& b, const ShipMaterials& m, const Path& feet, const Path& heads,
                 float step) {
    const glm::vec2 deadeye[] = {
        {0, -0.06F}, {0.09F, -0.04F}, {0.11F, 0}, {0.09F, 0.04F}, {0, 0.06F}};
    for (std::size_t i = 0; i < feet.size(); ++i) {
        lay(b, m, feet[i], heads[i], 0.030F);
        b.lathe(move(feet[i]) * turn(0.5F * std::numbers::pi_v<float>, {1, 0, 0}), m.iron, deadeye,
                12, true);
    }
    const float height = heads[0].y - feet[0].y;
    const int count = static_cast<int>(0.85F * height / step);
    for (int k = 1; k < count; ++k) {
        const float s = 0.03F + static_cast<float>(k) * step / height;
        for (std::size_t i = 0; i + 1 < feet.size(); ++i)
            lay(b, m, glm::mix(feet[i], heads[i], s), glm::mix(feet[i + 1], heads[i + 1], s),
                0.014F, 0.02F);
    }
}

/// A rail round the foot of a mast, where its running rigging is made fast.
void add_fife_rail(MeshBuilder& b, const ShipMaterials& m, float x) {
    const float deck = deck_at(x);
    for (const float side : {-1.0F, 1.0F}) {
        b.box(move({x, deck + 0.95F, side * 1.0F}), m.joinery, {-0.7F, 0, -0.09F},
              {0.9F, 0.08F, 0.09F});
        for (const float end : {-0.5F, 0.7F})
            b.box(move({x + end, deck + 0.12F, side * 1.0F}), m.joinery, {-0.07F, 0, -0.07F},
                  {0.07F, 0.826F, 0.07F});
    }
}

/// `aft_x` is where the next mast stands.
void add_mast(MeshBuilder& b, const ShipMaterials& m, const Mast& mast, bool square, float aft_x) {
    const float deck = deck_at(mast.x);
    const glm::vec3 foot{mast.x, -4.6F, 0};
    const float top = deck + mast.lower;
    const float crosstrees = deck + mast.upper;
    const glm::vec2 lower[] = {{0.42F, 0},
                               {0.44F, 4},
                               {0.43F, 9},
                               {0.38F, 14},
                               {0.32F, top + 2.4F + 4.6F},
                               {0, top + 2.5F + 4.6F}};
    b.lathe(move(foot), m.spars, lower, 20, true);
    const glm::vec2 middle[] = {{0, -0.1F},
                                {0.24F, 0},
                                {0.24F, 3},
                                {0.20F, mast.upper - mast.lower + 1.8F},
                                {0, mast.upper - mast.lower + 1.9F}};
    b.lathe(move({mast.x + 0.62F, top - 0.4F, 0}), m.spars, middle, 16, true);
    const float pole = mast.height - mast.upper;
    const glm::vec2 upper[] = {
        {0, -0.1F},       {0.15F, 0}, {0.14F, 0.5F * pole}, {0.07F, pole}, {0.13F, pole + 0.04F},
        {0, pole + 0.12F}};
    b.lathe(move({mast.x + 1.02F, crosstrees - 0.3F, 0}), m.spars, upper, 14, true);
    add_fife_rail(b, m, mast.x);
    for (int i = 0; i < 5; ++i) { // wooldings
        const glm::vec2 band[] = {{0.45F, 0}, {0.47F, 0.01F}, {0.47F, 0.15F}, {0.45F, 0.16F}};
        b.lathe(move({mast.x, deck + 2.0F + 1.9F * static_cast<float>(i), 0}), m.rope, band, 20);
    }
    // The top, a platform of boards on trestle trees, with a lubber's hole either side.
    for (int i = 0; i < 11; ++i) {
        const float z = -1.65F + 0.30F * static_cast<float>(i);
        const float half = std::abs(z) < 1.0F ? 1.25F : 1.05F;
        b.box(move({mast.x + 0.3F, top, z}), m.deck,
              {half > 1.2F && std::abs(z) < 0.55F ? 0.62F : -half, 0, 0.004F},
              {half, 0.06F, 0.296F});
        if (std::abs(z) < 0.55F)
            b.box(move({mast.x + 0.3F, top, z}), m.deck, {-half, 0, 0.004F},
                  {-0.74F, 0.06F, 0.296F});
    }
    for (const float side : {-1.0F, 1.0F}) {
        b.box(move({mast.x + 0.3F, top, side * 0.52F}), m.spars, {-1.4F, -0.26F, -0.08F},
              {1.4F, -gap, 0.08F});
        b.box(move({mast.x + 0.8F, crosstrees, side * 0.3F}), m.spars, {-0.7F, -0.16F, -0.05F},
              {0.7F, -gap, 0.05F});
        const float gunwale = hull::half_breadth(mast.x, hull::sheer(mast.x)) + 0.28F;
        b.box(move({mast.x - 1.4F, hull::sheer(mast.x) - 0.12F, side * gunwale}), m.joinery,
              {-2.6F, -0.06F, -0.24F}, {2.6F, 0.06F, 0.24F});
        Path feet;
        Path heads;
        for (int i = 0; i < 5; ++i) {
            const float x = mast.x + 0.5F - 0.92F * static_cast<float>(i);
            feet.emplace_back(x, hull::sheer(mast.x) + 0.28F, side * (gunwale + 0.05F));
            heads.emplace_back(mast.x + 0.1F - 0.03F * static_cast<float>(i), top + 0.55F,
                               side * (0.42F - 0.01F * static_cast<float>(i)));
        }
        add_shrouds(b, m, feet, heads, 0.85F);
        for (const glm::vec3& p : feet) { // chain plates, down to the upper wale
            const float y = p.y - 1.5F;
            b.rod(m.iron, p - glm::vec3(0, 0.12F, 0),
                  {p.x, y, side * (hull::half_breadth(p.x, y) + 0.10F)}, 0.025F, 4);
        }
        Path upper_feet;
        Path upper_heads;
        for (int i = 0; i < 3; ++i) {
            const float s = static_cast<float>(i);
            upper_feet.emplace_back(mast.x + 0.7F - 0.70F * s, top + 0.12F, side * 1.62F);
            upper_heads.emplace_back(mast.x + 0.66F - 0.02F * s, crosstrees + 0.4F,
                                     side * (0.22F - 0.01F * s));
        }
        add_shrouds(b, m, upper_feet, upper_heads, 0.85F);
        for (int i = 0; i < 3; ++i) { // backstays, made fast on the rail
            const float x = mast.x - 4.4F - 0.6F * static_cast<float>(i);
            const float heights[] = {crosstrees, crosstrees + 0.5F * pole,
                                     crosstrees + 0.9F * pole};
            lay(b, m,
                {x, hull::sheer(x) + 0.10F, side * (hull::half_breadth(x, hull::sheer(x)) - 0.05F)},
                {mast.x + (i == 0 ? 0.62F : 0.95F), heights[i], side * 0.16F}, 0.022F);
        }
    }
    const float levels[] = {top - 1.0F, top + 3.4F, top + 6.4F, crosstrees + 1.6F,
                            crosstrees + 5.6F};
    const float halves[] = {9.0F, 8.0F, 7.4F, 5.6F, 4.1F};
    for (int i = 0; square && i < 5; ++i) {
        const glm::vec3 yard{mast.x + (i == 0 ? 0.75F : i < 3 ? 1.20F : 1.45F), levels[i], 0};
        add_yard(b, m, yard, halves[i], 0.24F - 0.03F * static_cast<float>(i));
        if (i == 0 || i == 4) {
            add_furled_sail(b, m, yard, halves[i] * 0.9F, 0.24F - 0.03F * static_cast<float>(i));
        } else {
            const float foot_y = levels[i - 1] + 0.35F;
            add_square_sail(b, m, yard + glm::vec3(0.22F, -0.16F, 0), halves[i] * 0.9F, foot_y,
                            halves[i - 1] * 0.9F, 0.30F * (levels[i] - levels[i - 1]), 18);
        }
        for (const float side : {-1.0F, 1.0F}) {
            // Braces lead aft: the lowest to the rail, the others to the next mast and down it.
            const glm::vec3 arm = yard + glm::vec3(-0.1F, 0, side * halves[i]);
            const float rail = mast.x - 10.5F;
            const float height = mast.lower - 3.0F + 2.4F * static_cast<float>(i);
            const glm::vec3 lead =
                i == 0 ? glm::vec3(rail, hull::sheer(rail) + 0.10F,
                                   side * hull::half_breadth(rail, hull::sheer(rail)))
                       : glm::vec3(aft_x + (i < 2 ? 0.38F : 0.86F), deck + height, side * 0.12F);
            lay(b, m, arm, lead, 0.016F, 0.25F);
            // Halyard or bunt line, down to the rail at the foot of the mast.
            if (i == 0) continue;
            lay(b, m, yard + glm::vec3(-0.3F, 0, side * 0.25F),
                {mast.x - 0.6F + 0.4F * static_cast<float>(i), deck + 1.03F, side * 1.0F}, 0.014F);
        }
    }
}

} // namespace

void add_rigging(MeshBuilder& b, const ShipMaterials& m) {
    add_mast(b, m, masts[0], true, masts[1].x);
    add_mast(b, m, masts[1], true, masts[2].x);
    add_mast(b, m, masts[2], false, 0);

    // Bowsprit and jib boom, their stays and jibs.
    const glm::vec3 heel{24.5F, hull::sheer(24.5F) - 0.2F, 0};
    const glm::vec3 cap{34.5F, hull::sheer(28) + 2.6F, 0};
    const glm::vec3 tip{43.0F, hull::sheer(28) + 5.2F, 0};
    const glm::vec2 sprit[] = {{0, 0}, {0.34F, 0.02F}, {0.36F, 4}, {0.27F, 10.4F}, {0, 10.5F}};
    b.lathe(along(heel, cap), m.spars, sprit, 16, true);
    const glm::vec3 boom = glm::mix(heel, cap, 0.72F) + glm::vec3(0, 0.55F, 0);
    const glm::vec2 jib[] = {{0, 0}, {0.18F, 0.02F}, {0.18F, 5}, {0.09F, 11.6F}, {0, 11.7F}};
    b.lathe(along(boom, tip), m.spars, jib, 14, true);
    const glm::vec3 fore_top{16.6F, deck_at(16.5F) + 13, 0};
    const glm::vec3 fore_cross{17.3F, deck_at(16.5F) + 23, 0};
    const glm::vec3 fore_truck{17.5F, deck_at(16.5F) + 31, 0};
    lay(b, m, cap, fore_top, 0.035F);
    lay(b, m, glm::mix(boom, tip, 0.55F), fore_cross, 0.026F);
    lay(b, m, tip, fore_truck, 0.022F);
    add_staysail(b, m, glm::mix(cap, fore_top, 0.06F), glm::mix(cap, fore_top, 0.86F),
                 {21.5F, 8.2F, 0.3F}, 7, 16);
    add_staysail(b, m, glm::mix(glm::mix(boom, tip, 0.55F), fore_cross, 0.05F),
                 glm::mix(glm::mix(boom, tip, 0.55F), fore_cross, 0.80F), {26.5F, 9.8F, 0.3F}, 7,
                 16);
    add_staysail(b, m, glm::mix(tip, fore_truck, 0.05F), glm::mix(tip, fore_truck, 0.74F),
                 {31.0F, 12.0F, 0.3F}, 8, 16);
    for (const float side : {-1.0F, 1.0F}) { // bowsprit shrouds and the net below the boom
        lay(b, m, cap,
            {26.5F, hull::sheer(26) - 1.2F,
             side * (hull::half_breadth(26.5F, hull::sheer(26) - 1.2F) + 0.02F)},
            0.025F);
        lay(b, m, tip,
            {28.0F, hull::sheer(28) + 0.1F, side * hull::half_breadth(28, hull::sheer(28))},
            0.020F);
        lay(b, m, glm::mix(cap, tip, 0.1F) + glm::vec3(0, -0.2F, side * 0.4F),
            tip + glm::vec3(0, -0.15F, side * 0.08F), 0.016F, 0.5F);
    }
    // Stays from mast to mast.
    for (int i = 0; i < 2; ++i) {
        const Mast& fore = masts[i];
        const Mast& aft = masts[i + 1];
        lay(b, m, {fore.x - 0.42F, deck_at(fore.x) + 1.0F, 0},
            {aft.x + 0.3F, deck_at(aft.x) + aft.lower, 0}, 0.032F);
        lay(b, m, {fore.x - 0.31F, deck_at(fore.x) + fore.lower, 0},
            {aft.x + 0.8F, deck_at(aft.x) + aft.upper, 0}, 0.026F);
        lay(b, m, {fore.x + 0.43F, deck_at(fore.x) + fore.upper, 0},
            {aft.x + 1.0F, deck_at(aft.x) + aft.height - 1, 0}, 0.020F);
    }
    // Spanker: gaff, boom and sail on the mizzen.
    const float x = masts[2].x - 0.5F;
    const float deck = deck_at(masts[2].x);
    const glm::vec3 throat{x, deck + 9.2F, 0};
    const glm::vec3 peak{x - 8.5F, deck + 14.0F, 0};
    const glm::vec3 tack{x, deck + 2.9F, 0};
    const glm::vec3 clew{x - 13.5F, deck + 3.8F, 0};
    b.rod(m.spars, throat, peak, 0.13F, 14);
    b.rod(m.spars, tack, clew, 0.16F, 14);
    auto point = [&](float s, float t) {
        const glm::vec3 p = glm::mix(glm::mix(tack, clew, s * 0.97F),
                                     glm::mix(throat, peak, s * 0.97F), 0.04F + 0.92F * t);
        return p +
               glm::vec3(0, 0, 0.9F * std::sin(3.14F * s) * std::sin(3.14F * (0.1F + 0.8F * t)));
    };
    constexpr int cloths = 8;
    for (int i = 0; i < cloths; ++i) {
        const float s0 = 0.03F + 0.97F * static_cast<float>(i) / cloths;
        const float s1 = std::min(1.0F, 0.03F + 0.97F * (static_cast<float>(i) + 1.02F) / cloths);
        b.panel(glm::mat4(1), m.sail, 4, 16, [&](float u, float v) {
            return point(glm::mix(s1, s0, u), v) + glm::vec3(0, 0, 0.02F * (1 - u));
        });
    }
    lay(b, m, peak, {masts[2].x + 0.41F, deck + 17, 0}, 0.018F);
    lay(b, m, clew + glm::vec3(0.4F, 0, 0), {masts[2].x + 0.42F, deck + 19, 0}, 0.018F);
}

} // namespace lineatlas::scenes
