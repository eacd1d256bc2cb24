// The sails of the ship: sewn cloths, set or furled; and the ropes they hang on.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

#include "ship_parts.hpp"

namespace lineatlas::scenes {

void lay(MeshBuilder& b, const ShipMaterials& m, glm::vec3 from, glm::vec3 to, float radius,
         float sag) {
    b.rope(m.rope, from, to, radius, sag > 0.1F ? 10 : sag > 0 ? 4 : 1, sag);
}

/// A square sail of sewn cloths, bellied forward, with a reef band.
void add_square_sail(MeshBuilder& b, const ShipMaterials& m, glm::vec3 head, float head_half,
                     float foot_y, float foot_half, float belly, int rows) {
    constexpr int cloths = 7;
    auto point = [&](float s, float t) { // s across in [-1, 1], t down in [0, 1]
        const float half = glm::mix(head_half, foot_half, t);
        const float roach = 0.35F * (1 - s * s) * t * t;
        const float depth =
            belly * (1 - 0.85F * s * s) * std::sin(std::numbers::pi_v<float> * (0.08F + 0.80F * t));
        return glm::vec3(head.x + depth, glm::mix(head.y, foot_y, t) + roach, s * half);
    };
    for (int i = 0; i < cloths; ++i) {
        const float s0 = 2 * static_cast<float>(i) / cloths - 1;
        const float s1 = std::min(1.0F, 2 * (static_cast<float>(i) + 1.02F) / cloths - 1);
        b.patch(
            glm::mat4(1), 4, rows,
            [&](float u, float v) { // each cloth starts before the end of the last one
                return point(glm::mix(s1, s0, u), 1 - v) + glm::vec3(0.02F * (1 - u), 0, 0);
            },
            [&](int row) { return row == 0 || row == rows - 1 ? m.tabling : m.sail; });
        const float s = 0.5F * (s0 + s1);
        for (const float across : {s - 0.5F / cloths, s + 0.5F / cloths}) { // reef points
            const glm::vec3 p = point(across, 0.25F) + glm::vec3(0.05F, 0, 0);
            lay(b, m, p, p + glm::vec3(0.10F, -0.50F, 0), 0.014F);
        }
    }
}

void add_furled_sail(MeshBuilder& b, const ShipMaterials& m, glm::vec3 yard, float half,
                     float radius) {
    // It lies on the yard, so that no line of the one hides in the other; gaskets hold both.
    auto round_up = [half, radius](float u, float v, float out) {
        const float angle = 2 * std::numbers::pi_v<float> * v;
        const float s = 2 * u - 1;
        const float thick = (0.26F - 0.12F * s * s) * (0.86F + 0.14F * std::abs(std::sin(u * 25)));
        return glm::vec3(0.9F * (thick + out) * std::cos(angle),
                         radius + gap + 0.05F + thick + (thick + out) * std::sin(angle),
                         half * 0.94F * s);
    };
    b.panel(move(yard), m.sail, 64, 10, [&](float u, float v) { return round_up(u, v, 0); });
    for (int i = 1; i < 8; ++i) {
        const float u = (static_cast<float>(i) * std::numbers::pi_v<float>) / 25;
        Path gasket;
        for (int k = 0; k < 12; ++k)
            gasket.push_back(round_up(u, static_cast<float>(k) / 12, 0.012F));
        b.tube(move(yard), m.rope, gasket, 0.02F, 3, true);
    }
}

/// A three-cornered sail on a stay.
void add_staysail(MeshBuilder& b, const ShipMaterials& m, glm::vec3 tack, glm::vec3 head,
                  glm::vec3 clew, int cloths, int rows) {
    auto point = [&](float across, float up) {
        const glm::vec3 luff = glm::mix(tack, head, up);
        const glm::vec3 leech = glm::mix(clew, head, up);
        const float belly =
            0.75F * std::sin(std::numbers::pi_v<float> * across) * (1 - up) * (0.25F + up);
        return glm::mix(luff, leech, across) + glm::vec3(0, 0, belly);
    };
    for (int i = 0; i < cloths; ++i) {
        const float y0 = static_cast<float>(i) / static_cast<float>(cloths);
        const float y1 =
            std::min(0.99F, (static_cast<float>(i) + 1.02F) / static_cast<float>(cloths));
        b.panel(glm::mat4(1), m.sail, rows, 6, [&](float u, float v) {
            return point(u, glm::mix(y0, y1, v)) + glm::vec3(0, 0, 0.02F * v);
        });
    }
}

} // namespace lineatlas::scenes
